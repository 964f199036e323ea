#include "core/base/remaining_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace bosk {
namespace {

constexpr double kSteadyFraction = 0.05;  // of the job, before remaining time is told
constexpr double kSteadySeconds = 3.0;
constexpr double kEstimateSeconds = 5.0;  // over which estimates are averaged

}  // namespace

std::optional<double> RemainingTime::update(double fraction, double spent_s) {
  if (fraction < kSteadyFraction || spent_s < kSteadySeconds) return std::nullopt;
  const double estimate = spent_s * (1.0 - fraction) / fraction;
  const double since = spent_s - told_s_;
  const double trust = left_s_ < 0.0 ? 1.0 : 1.0 - std::exp(-since / kEstimateSeconds);
  left_s_ += trust * (estimate - left_s_) - (1.0 - trust) * std::min(since, left_s_);
  told_s_ = spent_s;
  return left_s_;
}

std::string minutes_text(double seconds) {
  const long whole = std::lround(seconds);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%ld:%02ld", whole / 60, whole % 60);
  return text.data();
}

}  // namespace bosk
