#pragma once

#include <cassert>
#include <cstdint>

namespace bosk {

// Random numbers that are the same on every machine: SplitMix64 (Steele, Lea and Flood 2014), and
// no call whose last bit depends on the maths library. A stage takes its seed from its options and
// gives each photo, cell or pixel a stream of its own, so that the order of threads doesn't matter.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mixed(seed) ^ mixed(~stream * kStep)) {}

  std::uint64_t bits() { return mixed(state_ += kStep); }
  // From 0 up to, never including, 1, in steps of 2^-53.
  double uniform() { return double(bits() >> 11) * 0x1.0p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  // A whole number from 0 to count - 1, without bias.
  std::uint64_t below(std::uint64_t count) {
    assert(count > 0);
    const std::uint64_t unfair = (0 - count) % count;  // 2^64 mod count
    std::uint64_t drawn = bits();
    while (drawn < unfair) drawn = bits();
    return drawn % count;
  }
  // Mean 0, standard deviation 1. Exact sampling by comparisons alone (Karney 2016, "Sampling
  // exactly from the normal distribution", algorithm N), about 12 draws each.
  double normal() {
    while (true) {
      int whole = 0;
      while (survives(0.5)) ++whole;
      if (!survives(0.5 * whole * (whole - 1))) continue;
      const double part = uniform();
      if (!survives(0.5 * part * (2 * whole + part))) continue;
      return (bits() >> 63) != 0 ? whole + part : -(whole + part);
    }
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  // True with probability exp(-exponent): von Neumann's game, in rounds of at most 1.
  bool survives(double exponent) {
    for (; exponent > 1.0; exponent -= 1.0) {
      if (!survives_round(1.0)) return false;
    }
    return survives_round(exponent);
  }
  bool survives_round(double exponent) {
    int draws = 1;
    while (uniform() * draws < exponent) ++draws;
    return draws % 2 == 1;
  }

  std::uint64_t state_;
};

}  // namespace bosk
