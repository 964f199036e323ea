#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/phantom/tree_shape.h"

namespace bosk {

struct SkeletonNode {
  glm::dvec3 position{0.0};
  int parent = -1;  // a smaller index; -1 at the foot
  double radius = 0.0;
};

// The branches of a tree as a chain of points, parents before children. Space colonisation after
// Runions, Lane and Prusinkiewicz 2007, sections 2 and 3; radii by the pipe model,
// r_parent^n = sum of r_child^n. Differs: one tropism for the whole tree, at most three children
// a node, and kinks are smoothed once at the end.
std::vector<SkeletonNode> grow_skeleton(const TreeShape& shape, std::uint64_t seed,
                                        Progress& progress);

}  // namespace bosk
