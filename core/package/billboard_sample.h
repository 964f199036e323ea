#pragma once

#include <cstddef>
#include <vector>

#include "core/billboard/billboard.h"

namespace bosk {

// Part of a tree's billboards, fit to be coded and packed as a tree of its own.
struct BillboardSample {
  Billboards billboards;
  std::vector<double> scale;  // of each level: blocks of the whole tree for each block taken
};

std::size_t block_count(const Billboards& billboards);  // of all levels

// About `blocks` blocks of 4x4 texels: whole subtrees at equal steps all over the tree, and every
// cell of the levels above their roots. All of a tree that has no more, or too few cells to choose.
BillboardSample sample_of(const Billboards& billboards, std::size_t blocks);

}  // namespace bosk
