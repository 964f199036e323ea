#pragma once

#include <cstdint>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

struct SampleTreeOptions {
  std::vector<int> levels{2, 3};  // of the octree
  int texels = 4;
  int views = 6;
  std::uint32_t alpha_codewords = 24, colour_codewords = 40;
  std::uint64_t seed = 1;
};

// A made-up tree that a package takes: cells in the shell of a ball, pruned where the ball hides
// them; from view to view and from cell to cell an index stays or moves to a codeword that looks
// alike, as baked textures do. The codebooks are ordered by brightness.
TreeModel sample_tree(const SampleTreeOptions& options);

// Whether every field is the same, floats bit for bit.
bool same_tree(const TreeModel& a, const TreeModel& b);

}  // namespace bosk
