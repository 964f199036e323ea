#pragma once

#include <cstdint>
#include <optional>

namespace bosk {

// What the trees of the last frame took, and how many billboards they were.
struct FrameCost {
  double ms = 0.0;
  std::uint64_t billboards = 0;
};

// What trees may take of a frame of `frame_ms` when all else takes `other_ms`: the rest, but at
// least half as much as the other. Where that alone is too slow, poorer trees would gain little.
double time_for_trees(double frame_ms, double other_ms);

inline constexpr std::uint64_t kLeastBudget = 2000;

// How many billboards the next frame may draw so that trees come to take `target_ms`. Each call
// changes `budget` by at most a factor of 2 down and 1.25 up, and not at all within a tenth of the
// target: frames that jitter leave it alone. It grows no further than a quarter above what a frame
// drew, so that a sudden wide view isn't met with a budget from an empty one; at most `most`
// (0: no bound).
std::uint64_t adapted_budget(std::uint64_t budget, const FrameCost& last, double target_ms,
                             std::uint64_t most);

// What a picture that stands still may draw, after one that was drawn with `budget`, in about
// `still_ms` (0: as long as it needs); at most eight times as much as the last one at a time. None
// when it may not become half as good again, or had `most` already.
std::optional<std::uint64_t> still_budget(std::uint64_t budget, const FrameCost& last,
                                          double still_ms, std::uint64_t most);

}  // namespace bosk
