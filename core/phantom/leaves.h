#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/random.h"
#include "core/phantom/tree_shape.h"

namespace bosk {

// Leaves as triangles, the same number for each leaf. Anchors: the foot of the leaf.
struct LeafMesh {
  std::vector<glm::vec3> vertices, anchors;
  std::vector<glm::uvec3> triangles;
  std::size_t triangles_per_facet = 1, facets_per_leaf = 1;
  std::vector<glm::vec2> outline;  // of one half, from foot to tip: (along, across), in lengths
};

LeafMesh empty_leaf_mesh(LeafKind kind);

// Sets leaves along a straight shoot, alternating round it, drooping and turned at random.
void add_leaves_along(const glm::dvec3& from, const glm::dvec3& to, const TreeShape& shape,
                      Random& random, LeafMesh& mesh);

}  // namespace bosk
