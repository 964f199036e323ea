#include "ui/frame_budget.h"

#include <algorithm>
#include <cmath>

namespace bosk {

double time_for_trees(double frame_ms, double other_ms) {
  return std::max(frame_ms - other_ms, 0.5 * other_ms);
}

std::uint64_t adapted_budget(std::uint64_t budget, const FrameCost& last, double target_ms,
                             std::uint64_t most) {
  const std::uint64_t bound = most == 0 ? UINT64_MAX : std::max(most, kLeastBudget);
  if (last.ms <= 0.0 || target_ms <= 0.0) return std::min(budget == 0 ? bound : budget, bound);
  const double drawn = double(std::max(last.billboards, kLeastBudget));
  const double ratio = target_ms / last.ms;
  double next = budget == 0 ? double(bound) : double(budget);
  if (ratio < 0.9) next = std::min(next, drawn) * std::max(ratio, 0.5);
  if (ratio > 1.1 && next < 1.25 * drawn) next *= std::min(ratio, 1.25);
  if (next >= double(bound)) return bound;
  return std::max(std::uint64_t(next), kLeastBudget);
}

std::optional<std::uint64_t> still_budget(std::uint64_t budget, const FrameCost& last,
                                          double still_ms, std::uint64_t most) {
  if (budget == most || (most > 0 && budget > most)) return std::nullopt;
  if (still_ms <= 0.0) return most;
  const double factor = std::min(still_ms / std::max(last.ms, 1e-3), 8.0);
  if (factor < 1.5) return std::nullopt;
  const double next = factor * double(std::max(last.billboards, kLeastBudget));
  if (most > 0 && next >= double(most)) return most;
  return std::uint64_t(next);
}

}  // namespace bosk
