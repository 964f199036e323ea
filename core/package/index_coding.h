#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

// How the indices of one level become bytes: the bulk of a package. First which blocks are live
// (not pruned), then the indices of live blocks, alpha and colour apart. Each index that came
// before has a list of the indices that were seen to follow it; what follows now is told by its
// rank there. Lists learn as they go. Symbols are range coded (rANS). The walks below are shared by
// reader and writer, so the two can't disagree.
namespace bosk {

struct IndexShape {
  std::size_t cells = 0, views = 0, blocks = 0;  // blocks of one billboard's texture: 1 or 4

  std::size_t slots() const { return cells * blocks; }
  std::size_t per_cell() const { return views * blocks; }
  std::size_t count() const { return cells * per_cell(); }
};

inline constexpr unsigned kTokenBits = 12, kDirectBits = 14;  // chances are out of 2^ these
inline constexpr std::uint32_t kRansLow = 1u << 16;           // coder states stay in [2^16, 2^32)
inline constexpr unsigned kRansStates = 2;                    // take turns
inline constexpr unsigned kLiveContexts = 24;
inline constexpr unsigned kMaxRanks = 255;
inline constexpr std::size_t kChunkIndices = std::size_t(1) << 20;

// Cells `first` to `first + shape.cells - 1` of a level, coded with no knowledge of the others so
// that threads can share a level.
struct IndexChunk {
  std::size_t first = 0;
  IndexShape shape;

  // Its part of an array over the level's indices.
  template <class T>
  std::span<T> of(std::span<T> level) const {
    return level.subspan(first * shape.per_cell(), shape.count());
  }
};
inline std::vector<IndexChunk> index_chunks(const IndexShape& shape) {
  std::vector<IndexChunk> chunks;
  if (shape.per_cell() == 0) return chunks;
  const std::size_t step = std::max<std::size_t>(1, kChunkIndices / shape.per_cell());
  for (std::size_t first = 0; first < shape.cells; first += step) {
    const std::size_t cells = std::min(step, shape.cells - first);
    chunks.push_back({first, {cells, shape.views, shape.blocks}});
  }
  return chunks;
}

// A chunk is coded view by view, in each cell by cell. Both functions go through groups of cells
// small enough for the cache; kBlocks is a constant so that the inner loop unrolls.
template <std::size_t kBlocks, bool kToViewOrder>
void reorder(std::span<const std::uint16_t> from, const IndexShape& shape,
             std::span<std::uint16_t> to) {
  constexpr std::size_t kGroup = 64;
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
}
inline std::vector<std::uint16_t> view_order(std::span<const std::uint16_t> in_cell_order,
                                             const IndexShape& shape) {
  std::vector<std::uint16_t> to(shape.count());
  shape.blocks == 1 ? reorder<1, true>(in_cell_order, shape, to)
                    : reorder<4, true>(in_cell_order, shape, to);
  return to;
}
inline void cell_order(std::span<const std::uint16_t> in_view_order, const IndexShape& shape,
                       std::span<std::uint16_t> to) {
  shape.blocks == 1 ? reorder<1, false>(in_view_order, shape, to)
                    : reorder<4, false>(in_view_order, shape, to);
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
  // Lists of indices below `count` for each index below `befores`.
  RankLists(std::uint32_t befores, std::uint32_t count, std::uint32_t length)
      : length_(std::min(length, count)), lists_(std::size_t(befores) * length_) {
    for (std::uint32_t before = 0; before < befores; ++before) {
      std::uint16_t* list = lists_.data() + std::size_t(before) * length_;
      const std::uint32_t index = std::min(before, count - 1);
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

// Tokens have statistics apart for how far down the list the same block's index was before: 0 where
// it was told directly or is the first, else 1 for rank 0, 2 for 1 and 2, 3 for 3 to 6, and so on.
inline constexpr unsigned kTokenContexts = 7;
inline constexpr std::array<std::uint8_t, kMaxRanks + 1> kContextAfterRank = [] {
  std::array<std::uint8_t, kMaxRanks + 1> contexts{};
  for (unsigned rank = 0; rank <= kMaxRanks; ++rank) {
    for (unsigned above = rank + 1; above > 0; above /= 2) ++contexts[rank];
    contexts[rank] = std::uint8_t(std::min<unsigned>(contexts[rank], kTokenContexts - 1));
  }
  return contexts;
}();

// What a block's next index goes by.
struct BlockPast {
  std::uint16_t before = kPruned;
  std::uint16_t context = 0;
};

// The level above as far as its indices tell of this level's: a cell begins from the first live
// index of its parent.
struct ParentIndices {
  std::span<const std::uint64_t> child_cells, cells;  // Morton codes of this level, of that above
  unsigned shift = 3;                                 // from a child's code to its parent's
  std::span<const std::uint16_t> alpha, indices;  // of the level above; alpha tells what is live
  std::size_t per_cell = 0;
};

// `indices`: the alpha or colour of `before`, the level before in the package.
inline ParentIndices parent_indices(const TreeLevel& level, const TreeLevel& before,
                                    std::span<const std::uint16_t> indices) {
  const auto across = std::size_t(before.texels / 4);
  return {level.cells,          before.cells, unsigned(3 * (level.level - before.level)),
          before.alpha_indices, indices,      before.views.size() * across * across};
}

// The first live index of a cell above; kPruned when it has none.
inline std::uint16_t first_live(const ParentIndices& parents, std::size_t cell) {
  const std::size_t from = cell * parents.per_cell;
  for (std::size_t i = from; i < from + parents.per_cell; ++i) {
    if (parents.alpha[i] != kPruned) return parents.indices[i];
  }
  return kPruned;
}

// What the slots of a chunk begin from. Cells of both levels ascend, so one walk finds all parents.
inline std::vector<BlockPast> first_past(const IndexChunk& chunk, const ParentIndices* parents) {
  std::vector<BlockPast> past(chunk.shape.slots());
  if (!parents) return past;
  const auto children = parents->child_cells.subspan(chunk.first, chunk.shape.cells);
  auto parent = std::lower_bound(parents->cells.begin(), parents->cells.end(),
                                 children.front() >> parents->shift);
  std::uint64_t code = ~std::uint64_t(0);
  std::uint16_t index = kPruned;
  for (std::size_t cell = 0; cell < children.size(); ++cell) {
    const std::uint64_t wanted = children[cell] >> parents->shift;
    if (wanted != code) {
      code = wanted;
      while (parent != parents->cells.end() && *parent < code) ++parent;
      const bool is_there = parent != parents->cells.end() && *parent == code;
      index =
          is_there ? first_live(*parents, std::size_t(parent - parents->cells.begin())) : kPruned;
    }
    for (std::size_t block = 0; block < chunk.shape.blocks; ++block) {
      past[cell * chunk.shape.blocks + block].before = index;
    }
  }
  return past;
}

// A coder for the walks: an encoder gets values and returns them, a decoder ignores what it gets.
//   bool flag(unsigned context, bool value)
//   unsigned token(unsigned context, rank)          rank(): the value, worked out by an encoder
//   only std::uint16_t direct(std::uint16_t value)
// Coders are handed over and back by value, so that their state lives in registers.

// Slots of the two halves of a chunk take turns: so what a flag needs of its neighbour is known one
// step before, and a processor can work on both. (Where the halves meet, the neighbour is that of
// the view before.)
template <class Coder>
Coder walk_live(const IndexShape& shape, std::span<std::uint8_t> live, Coder coder) {
  LiveContexts contexts(shape);
  const std::size_t slots = shape.slots(), half = slots / 2;
  for (std::size_t view = 0; view < live.size(); view += slots) {
    const auto code = [&](std::size_t slot) {
      std::uint8_t& is_live = live[view + slot];
      is_live = coder.flag(contexts.context(slot), is_live != 0);
      contexts.set(slot, is_live != 0);
    };
    for (std::size_t slot = 0; slot < half; ++slot) {
      code(slot);
      code(half + slot);
    }
    if (slots % 2 != 0) code(slots - 1);
  }
  return coder;
}

// The live ones among up to 256 blocks, found without a branch that a processor must guess.
struct LiveRun {
  std::array<std::uint8_t, 256> blocks;
  std::size_t count = 0;

  explicit LiveRun(std::span<const std::uint8_t> live) {
    for (std::size_t i = 0; i < live.size(); ++i) {
      blocks[count] = std::uint8_t(i);
      count += live[i] != 0;
    }
  }
};

// `past`: of each slot, as the chunk begins. Indices of blocks that are not live stay as they are.
template <class Coder>
Coder walk_indices(std::span<const std::uint8_t> live, std::vector<BlockPast> past, RankLists lists,
                   std::span<std::uint16_t> values, Coder coder) {
  const auto code = [&](std::uint16_t& coded, BlockPast& known) {
    const BlockPast then = known;
    std::uint16_t value = coded, context = 0;
    const unsigned rank = then.before == kPruned ? lists.length() : coder.token(then.context, [&] {
      return lists.rank(then.before, value);
    });
    if (rank < lists.length()) {
      value = lists.take(then.before, rank);
      context = kContextAfterRank[rank];
    } else {
      value = coder.direct(value);
      if (then.before != kPruned) lists.learn(then.before, value);
    }
    coded = value;
    known = {value, context};
  };
  for (std::size_t view = 0; view < values.size(); view += past.size()) {
    for (std::size_t slot = 0; slot < past.size(); slot += 256) {
      const LiveRun run(live.subspan(view + slot, std::min<std::size_t>(256, past.size() - slot)));
      for (std::size_t k = 0; k < run.count; ++k) {
        const std::size_t at = slot + run.blocks[k];
        code(values[view + at], past[at]);
      }
    }
  }
  return coder;
}

}  // namespace bosk
