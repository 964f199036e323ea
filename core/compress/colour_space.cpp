#include "core/compress/colour_space.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr std::size_t kTexels = 16;
using Channel = std::array<float, kTexels>;

std::array<float, 256> linear_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = linear_from_srgb(float(i) / 255.0f);
  return table;
}

// For 1e-3 < x < 2: a guess from the exponent, then Halley's rule twice; relative error below 1e-6.
inline float fast_cube_root(float x) {
  const float third = float(std::bit_cast<std::int32_t>(x)) * (1.0f / 3.0f);
  float root = std::bit_cast<float>(std::int32_t(third) + 709921077);
  for (int i = 0; i < 2; ++i) {
    const float cube = root * root * root;
    root *= (cube + 2.0f * x) / (2.0f * cube + x);
  }
  return root;
}

// ln(1 + y) / y for 0 <= y < 10, relative error below 1e-5: exponent, then the series of artanh.
inline float log_ratio(float y) {
  const std::int32_t bits = std::bit_cast<std::int32_t>(1.0f + y);
  const float exponent = float((bits >> 23) - 127);
  const float mantissa = std::bit_cast<float>((bits & 0x7fffff) | 0x3f800000);
  const float s = (mantissa - 1.0f) / (mantissa + 1.0f);
  const float s2 = s * s;
  const float series = 1.0f + s2 * (1.0f / 3 + s2 * (1.0f / 5 + s2 * (1.0f / 7 + s2 * (1.0f / 9))));
  const float logarithm = exponent * 0.69314718f + 2.0f * s * series;
  return y > 1e-3f ? logarithm / y : 1.0f - 0.5f * y;
}

inline float lab_curve(float t) {
  const float root = fast_cube_root(t > 0.008856452f ? t : 0.008856452f);
  return t > 0.008856452f ? root : t * 7.787037f + 16.0f / 116.0f;
}

struct Coordinates {
  Channel first, second, third;
};

// D65, as core/image/colour.h; white divides out of the matrix rows.
Coordinates lab_coordinates(const Channel& r, const Channel& g, const Channel& b) {
  Coordinates lab;
  for (std::size_t i = 0; i < kTexels; ++i) {
    const float x = (0.4124564f * r[i] + 0.3575761f * g[i] + 0.1804375f * b[i]) * (1.0f / 0.95047f);
    const float y = 0.2126729f * r[i] + 0.7151522f * g[i] + 0.0721750f * b[i];
    const float z = (0.0193339f * r[i] + 0.1191920f * g[i] + 0.9503041f * b[i]) * (1.0f / 1.08883f);
    const float fx = lab_curve(x), fy = lab_curve(y), fz = lab_curve(z);
    lab.first[i] = 116.0f * fy - 66.0f;
    lab.second[i] = 500.0f * (fx - fy);
    lab.third[i] = 200.0f * (fy - fz);
  }
  return lab;
}

void compress_chroma(Coordinates& lab) {
  for (std::size_t i = 0; i < kTexels; ++i) {
    const float chroma = std::sqrt(lab.second[i] * lab.second[i] + lab.third[i] * lab.third[i]);
    const float scale = log_ratio(0.045f * chroma);
    lab.second[i] *= scale;
    lab.third[i] *= scale;
  }
}

}  // namespace

void write_coordinates(const BlockColours& srgb, ColourSpace space,
                       std::array<float, 48>& coordinates) {
  static const std::array<float, 256> linear = linear_table();
  if (space == ColourSpace::srgb) {
    for (std::size_t i = 0; i < 48; ++i) {
      coordinates[i] = (float(srgb[i / 3][int(i % 3)]) - 127.5f) * (100.0f / 255.0f);
    }
    return;
  }
  Channel r, g, b;
  for (std::size_t i = 0; i < kTexels; ++i) {
    r[i] = linear[srgb[i].r];
    g[i] = linear[srgb[i].g];
    b[i] = linear[srgb[i].b];
  }
  Coordinates lab = lab_coordinates(r, g, b);
  if (space == ColourSpace::lab_log_chroma) compress_chroma(lab);
  for (std::size_t i = 0; i < kTexels; ++i) {
    coordinates[3 * i] = lab.first[i];
    coordinates[3 * i + 1] = lab.second[i];
    coordinates[3 * i + 2] = lab.third[i];
  }
}

}  // namespace bosk
