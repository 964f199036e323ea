#pragma once

#include <cstdint>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// A cell of some level, by the Morton code of its first cell of the finest level.
struct CutCell {
  std::uint64_t code = 0;
  std::uint32_t number = 0;  // see PreparedTree::name_of
  std::uint32_t level = 0;
};
using Cut = std::vector<CutCell>;  // ascending codes

// One cut for each of `slots` (levels of the model with cells, coarse to fine): the level's own
// cells; finer cells that no cell from this level on holds; coarser cells with nothing finer below.
// `first_numbers`: of each level's first cell.
std::vector<Cut> octree_cuts(const TreeModel& model, const std::vector<std::uint32_t>& slots,
                             const std::vector<std::uint32_t>& first_numbers);

// The cells' numbers as an eye in the octant (bit per axis: on the high side) needs them, far to
// near.
void append_order(const Cut& cut, unsigned eye_octant, int finest_level,
                  std::vector<std::uint32_t>& order);

}  // namespace bosk
