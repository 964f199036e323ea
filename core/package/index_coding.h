#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/near_codewords.h"

// How the indices of one level become bytes: the bulk of a package. Two ways, the writer keeps the
// shorter:
//   planes  low bytes, then high bytes, view by view; zstd finds what repeats
//   ranked  each index is told as its rank among the codewords that look most like the one that the
//           same block had in the view before, and the ranks are range coded (rANS) with a context
// The walk below is shared by reader and writer, so the two can't disagree.
namespace bosk {

struct IndexShape {
  std::size_t cells = 0, views = 0, blocks = 0;  // blocks of one billboard's texture: 1 or 4

  std::size_t slots() const { return cells * blocks; }
  std::size_t count() const { return cells * views * blocks; }
};

enum class IndexTransform : std::uint8_t { planes = 0, ranked = 1 };

inline constexpr unsigned kProbabilityBits = 11;
inline constexpr unsigned kProbabilityOne = 1u << kProbabilityBits;
inline constexpr std::uint32_t kRansLow = 1u << 16;  // coder states stay within [2^16, 2^32)
inline constexpr unsigned kFlagContexts = 24;
inline constexpr unsigned kMaxNear = 64, kMaxBuckets = 64;
// Tokens: a rank below the list's length, or that length + the bits of the zigzag difference.
inline constexpr unsigned kEscapeTokens = 18;

// Indices are coded view by view, in each cell by cell. Both functions go through groups of cells
// small enough for the cache; kBlocks is a constant so that the inner loop unrolls.
template <std::size_t kBlocks, bool kToViewOrder>
std::vector<std::uint16_t> reordered(std::span<const std::uint16_t> from, const IndexShape& shape) {
  constexpr std::size_t kGroup = 64;
  std::vector<std::uint16_t> to(shape.count());
  for (std::size_t group = 0; group < shape.cells; group += kGroup) {
    const std::size_t end = std::min(group + kGroup, shape.cells);
    for (std::size_t view = 0; view < shape.views; ++view) {
      for (std::size_t cell = group; cell < end; ++cell) {
        const std::size_t by_cell = (cell * shape.views + view) * kBlocks;
        const std::size_t by_view = (view * shape.cells + cell) * kBlocks;
        for (std::size_t block = 0; block < kBlocks; ++block) {
          to[(kToViewOrder ? by_view : by_cell) + block] =
              from[(kToViewOrder ? by_cell : by_view) + block];
        }
      }
    }
  }
  return to;
}
inline std::vector<std::uint16_t> view_order(std::span<const std::uint16_t> in_cell_order,
                                             const IndexShape& shape) {
  return shape.blocks == 1 ? reordered<1, true>(in_cell_order, shape)
                           : reordered<4, true>(in_cell_order, shape);
}
inline std::vector<std::uint16_t> cell_order(std::span<const std::uint16_t> in_view_order,
                                             const IndexShape& shape) {
  return shape.blocks == 1 ? reordered<1, false>(in_view_order, shape)
                           : reordered<4, false>(in_view_order, shape);
}

// Context of "is this block pruned?": the same block in the view before, its neighbours in Morton
// order.
class LiveContexts {
 public:
  explicit LiveContexts(const IndexShape& shape)
      : reach_(shape.blocks), live_(shape.slots() + 2 * reach_ + 2, kUnknown) {}

  unsigned context(std::size_t slot) const {
    const std::uint8_t* here = live_.data() + reach_ + 1 + slot;
    const unsigned before = here[0], next = here[reach_] & 1u;
    const unsigned left = *(here - reach_) & 1u, third = *(here - (reach_ > 1 ? 1 : 2)) & 1u;
    return before * 8 + next * 4 + left * 2 + third;
  }
  void set(std::size_t slot, bool is_live) { live_[reach_ + 1 + slot] = is_live; }

 private:
  static constexpr std::uint8_t kUnknown = 2;
  std::size_t reach_;  // slots from a block to the same block of the next cell
  std::vector<std::uint8_t> live_;
};

// What a block's index is expected to be: the block's own of the last view that shows it, else that
// of the cell before.
class IndexPredictor {
 public:
  IndexPredictor(const IndexShape& shape, std::uint32_t codewords, unsigned buckets)
      : reach_(shape.blocks), last_(shape.slots() + shape.blocks, kPruned), context_of_(codewords) {
    middle_ = std::uint16_t(codewords / 2);
    for (std::uint32_t i = 0; i < codewords; ++i) {
      context_of_[i] = std::uint8_t(1 + std::uint64_t(i) * buckets / codewords);
    }
  }

  struct Expectation {
    std::uint16_t index;
    unsigned context;
  };
  Expectation expect(std::size_t slot) const {
    const std::uint16_t own = last_[slot + reach_];
    if (own != kPruned) return {own, context_of_[own]};
    const std::uint16_t neighbour = last_[slot];
    return {neighbour != kPruned ? neighbour : middle_, 0};
  }
  void set(std::size_t slot, std::uint16_t index) { last_[slot + reach_] = index; }

 private:
  std::size_t reach_;
  std::vector<std::uint16_t> last_;
  std::vector<std::uint8_t> context_of_;
  std::uint16_t middle_ = 0;
};

// One walk for both directions, over indices in view order. A coder has
//   bool flag(unsigned context, bool value)
//   std::uint16_t index(unsigned context, std::uint16_t expected, std::uint16_t value)
// An encoder returns the value, a decoder ignores what it gets. It is handed over and back by
// value: so its state lives in registers.
template <class Coder>
Coder walk_alpha(const IndexShape& shape, IndexPredictor predictor, std::span<std::uint16_t> values,
                 Coder coder) {
  LiveContexts live(shape);
  for (std::size_t i = 0; i < values.size();) {
    for (std::size_t slot = 0; slot < shape.slots(); ++slot, ++i) {
      const bool is_live = coder.flag(live.context(slot), values[i] != kPruned);
      live.set(slot, is_live);
      if (!is_live) {
        values[i] = kPruned;
        continue;
      }
      const auto expected = predictor.expect(slot);
      values[i] = coder.index(expected.context, expected.index, values[i]);
      predictor.set(slot, values[i]);
    }
  }
  return coder;
}

template <class Coder>
Coder walk_colour(const IndexShape& shape, IndexPredictor predictor,
                  std::span<const std::uint16_t> alpha, std::span<std::uint16_t> values,
                  Coder coder) {
  for (std::size_t i = 0; i < values.size();) {
    for (std::size_t slot = 0; slot < shape.slots(); ++slot, ++i) {
      if (alpha[i] == kPruned) continue;  // its colour index is 0
      const auto expected = predictor.expect(slot);
      values[i] = coder.index(expected.context, expected.index, values[i]);
      predictor.set(slot, values[i]);
    }
  }
  return coder;
}

}  // namespace bosk
