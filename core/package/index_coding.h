#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

// How the indices of one level become bytes: the bulk of a package. First which blocks are live
// (not pruned), then the indices of live blocks, alpha and colour apart, in one of two ways:
//   planes  low bytes, then high bytes; zstd finds what repeats
//   ranked  the index that the same block had in the view before has a list of the indices that
//   were
//           seen to follow it; what follows now is told by its rank there. Lists learn as they go.
// Symbols are range coded (rANS). The walks below are shared by reader and writer, so the two can't
// disagree.
namespace bosk {

struct IndexShape {
  std::size_t cells = 0, views = 0, blocks = 0;  // blocks of one billboard's texture: 1 or 4

  std::size_t slots() const { return cells * blocks; }
  std::size_t count() const { return cells * views * blocks; }
};

enum class IndexTransform : std::uint8_t { planes = 0, ranked = 1 };

inline constexpr unsigned kTokenBits = 12, kDirectBits = 14;  // chances are out of 2^ these
inline constexpr std::uint32_t kRansLow = 1u << 16;           // coder states stay in [2^16, 2^32)
inline constexpr unsigned kLiveContexts = 24;
inline constexpr unsigned kMaxRanks = 255, kMaxBuckets = 64;

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

// Context of "is this block live?": the same block in the view before, its neighbours in Morton
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

// For every index those that may follow it, likeliest first. They begin with the numbers around it
// (codewords are numbered so that near numbers look alike); what follows indeed moves up.
class RankLists {
 public:
  RankLists(std::uint32_t count, std::uint32_t length)
      : length_(std::min(length, count)), lists_(std::size_t(count) * length_) {
    for (std::uint32_t index = 0; index < count; ++index) {
      std::uint16_t* list = lists_.data() + std::size_t(index) * length_;
      std::uint32_t filled = 0;
      for (std::uint32_t step = 0; filled < length_; ++step) {
        if (step <= index) list[filled++] = std::uint16_t(index - step);
        if (filled < length_ && step > 0 && index + step < count) {
          list[filled++] = std::uint16_t(index + step);
        }
      }
    }
  }

  std::uint32_t length() const { return length_; }
  // The rank of `index` among the followers of `before`; length() when it is not there.
  std::uint32_t rank(std::uint16_t before, std::uint16_t index) const {
    const std::uint16_t* list = lists_.data() + std::size_t(before) * length_;
    return std::uint32_t(std::find(list, list + length_, index) - list);
  }
  // The follower of that rank, which changes places with the one half way to the front.
  std::uint16_t take(std::uint16_t before, std::uint32_t rank) {
    std::uint16_t* list = lists_.data() + std::size_t(before) * length_;
    const std::uint16_t index = list[rank];
    const std::uint32_t half = rank / 2;
    list[rank] = list[half];
    list[half] = index;
    return index;
  }
  // Puts in a follower that was not there, for the last.
  void learn(std::uint16_t before, std::uint16_t index) {
    lists_[std::size_t(before) * length_ + length_ - 1] = index;
  }

 private:
  std::uint32_t length_;
  std::vector<std::uint16_t> lists_;
};

// A coder for the walks: an encoder gets values and returns them, a decoder ignores what it gets.
//   bool flag(unsigned context, bool value)
//   unsigned token(unsigned context, rank)          rank(): the value, worked out by an encoder
//   only std::uint16_t direct(std::uint16_t value)
// Coders are handed over and back by value, so that their state lives in registers.

template <class Coder>
Coder walk_live(const IndexShape& shape, std::span<std::uint8_t> live, Coder coder) {
  LiveContexts contexts(shape);
  for (std::size_t i = 0; i < live.size();) {
    for (std::size_t slot = 0; slot < shape.slots(); ++slot, ++i) {
      live[i] = coder.flag(contexts.context(slot), live[i] != 0);
      contexts.set(slot, live[i] != 0);
    }
  }
  return coder;
}

// `values` in view order; those of blocks that are not live stay as they are.
template <class Coder>
Coder walk_indices(const IndexShape& shape, std::span<const std::uint8_t> live, std::uint32_t count,
                   unsigned buckets, RankLists lists, std::span<std::uint16_t> values,
                   Coder coder) {
  std::vector<std::uint16_t> last(shape.slots(), kPruned);  // of each block, where it was live
  std::vector<std::uint8_t> bucket(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    bucket[i] = std::uint8_t(std::uint64_t(i) * buckets / count);
  }
  for (std::size_t i = 0; i < values.size();) {
    for (std::size_t slot = 0; slot < shape.slots(); ++slot, ++i) {
      if (live[i] == 0) continue;
      const std::uint16_t before = last[slot];
      std::uint16_t value = values[i];
      if (before == kPruned) {
        value = coder.direct(value);
      } else {
        const unsigned rank =
            coder.token(bucket[before], [&] { return lists.rank(before, value); });
        if (rank < lists.length()) {
          value = lists.take(before, rank);
        } else {
          value = coder.direct(value);
          lists.learn(before, value);
        }
      }
      values[i] = last[slot] = value;
    }
  }
  return coder;
}

}  // namespace bosk
