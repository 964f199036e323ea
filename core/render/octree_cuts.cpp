#include "core/render/octree_cuts.h"

#include <algorithm>

namespace bosk {
namespace {

constexpr std::int32_t kNone = -1;

// What lies above and below each cell of one level.
struct Kinship {
  std::vector<std::int32_t> holder;     // place in `slots` of the finest coarser level whose cell
                                        // holds this one
  std::vector<std::uint8_t> has_finer;  // any cell of a finer level lies below
};

std::vector<Kinship> kinship_of(const TreeModel& model, const std::vector<std::uint32_t>& slots) {
  std::vector<Kinship> all(slots.size());
  for (std::size_t at = 0; at < slots.size(); ++at) {
    const TreeLevel& level = model.levels[slots[at]];
    all[at].holder.assign(level.cells.size(), kNone);
    all[at].has_finer.assign(level.cells.size(), 0);
    for (std::size_t above = at; above-- > 0;) {
      const TreeLevel& coarser = model.levels[slots[above]];
      const int shift = 3 * (level.level - coarser.level);
      std::size_t holder = 0;
      for (std::size_t i = 0; i < level.cells.size(); ++i) {
        const std::uint64_t code = level.cells[i] >> shift;
        while (holder < coarser.cells.size() && coarser.cells[holder] < code) ++holder;
        if (holder == coarser.cells.size()) break;
        if (coarser.cells[holder] != code || all[at].holder[i] != kNone) continue;
        all[at].holder[i] = std::int32_t(above);
        all[above].has_finer[holder] = 1;
      }
    }
  }
  return all;
}

// Writes the cells in the order of code ^ mask, descending: at each bit the half that the eye is
// not in comes first.
void append_halves(const CutCell* first, const CutCell* last, std::uint64_t mask, int bit,
                   std::vector<std::uint32_t>& order) {
  while (last - first > 1) {
    const std::uint64_t probe = std::uint64_t(1) << bit;
    const CutCell* middle = first;
    if (last - first > 16) {
      middle = std::partition_point(first, last,
                                    [&](const CutCell& cell) { return (cell.code & probe) == 0; });
    } else {
      while (middle != last && (middle->code & probe) == 0) ++middle;
    }
    --bit;
    if (middle == first || middle == last) continue;
    if ((mask & probe) != 0) {
      append_halves(first, middle, mask, bit, order);
      first = middle;
    } else {
      append_halves(middle, last, mask, bit, order);
      last = middle;
    }
  }
  if (first != last) order.push_back(first->number);
}

}  // namespace

std::vector<Cut> octree_cuts(const TreeModel& model, const std::vector<std::uint32_t>& slots,
                             const std::vector<std::uint32_t>& first_numbers) {
  const std::vector<Kinship> kinship = kinship_of(model, slots);
  const int finest = slots.empty() ? 0 : model.levels[slots.back()].level;
  std::vector<Cut> cuts(slots.size());
  for (std::size_t cut = 0; cut < slots.size(); ++cut) {
    std::size_t levels = 0;
    for (std::size_t at = 0; at < slots.size(); ++at) {
      const TreeLevel& level = model.levels[slots[at]];
      const int shift = 3 * (finest - level.level);
      const std::size_t before = cuts[cut].size();
      for (std::size_t i = 0; i < level.cells.size(); ++i) {
        const bool stands_in = at < cut ? kinship[at].has_finer[i] == 0
                                        : at == cut || kinship[at].holder[i] < std::int32_t(cut);
        if (!stands_in) continue;
        cuts[cut].push_back({level.cells[i] << shift, first_numbers[slots[at]] + std::uint32_t(i),
                             std::uint32_t(level.level)});
      }
      levels += cuts[cut].size() > before ? 1 : 0;
    }
    if (levels > 1) {
      std::sort(cuts[cut].begin(), cuts[cut].end(),
                [](const CutCell& a, const CutCell& b) { return a.code < b.code; });
    }
  }
  return cuts;
}

void append_order(const Cut& cut, unsigned eye_octant, int finest_level,
                  std::vector<std::uint32_t>& order) {
  std::uint64_t mask = 0;
  for (int level = 0; level < finest_level; ++level) mask = mask << 3 | eye_octant;
  append_halves(cut.data(), cut.data() + cut.size(), mask, 3 * finest_level - 1, order);
}

}  // namespace bosk
