#pragma once

#include <cstddef>
#include <cstdint>

#include "core/billboard/billboard.h"

namespace bosk::testing {

struct LeafyOptions {
  int cells = 200;
  int views = 6;           // on a ring around the cells
  int texels = 4;          // along a billboard's edge
  double leaves = 8;       // of a cell, on average; some cells have few, some many
  double leaf_size = 0.3;  // half the length of a leaf, of the cell's edge
  double pruned = 0.2;     // share of billboards that are clear
  double noise = 0.02;     // of encoded colour, per texel
  std::uint64_t seed = 1;
};

// One level of billboards that show little elliptic leaves: a cell's leaves are the same from every
// view, seen in parallel projection, so neighbouring views resemble each other as a tree's do.
BillboardLevel leafy_level(const LeafyOptions& options);
Billboards leafy_billboards(const LeafyOptions& options);  // that one level

}  // namespace bosk::testing
