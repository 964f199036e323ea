#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/phantom/skeleton.h"
#include "core/phantom/tree_shape.h"

namespace bosk {

// A tree as triangles: first the wood (tubes), then the leaves. A facet is a flat part of a leaf
// with a light of its own: one half of a folded leaf, or a whole needle. Metres, foot of the trunk
// at 0.
struct Tree {
  TreeShape shape;
  std::vector<glm::vec3> vertices;
  std::vector<glm::uvec3> triangles;
  std::size_t wood_vertices = 0, wood_triangles = 0;
  std::vector<glm::vec3> wood_normals;  // of the wood's vertices, outwards
  std::vector<glm::vec3>
      vertex_anchors;  // where each vertex hangs; the wind moves it as that point
  std::size_t triangles_per_facet = 1, facets_per_leaf = 1;

  std::size_t facet_count() const {
    return (triangles.size() - wood_triangles) / triangles_per_facet;
  }
  bool is_wood(std::size_t triangle) const { return triangle < wood_triangles; }
  std::size_t facet_of(std::size_t triangle) const {
    return (triangle - wood_triangles) / triangles_per_facet;
  }
  glm::vec3 normal(std::size_t triangle) const;  // unit, or zero for a triangle without area
  glm::vec3 point(std::size_t triangle, float u, float v) const;
};

Tree grow_tree(const TreeShape& shape, std::uint64_t seed, Progress& progress);

// Where the wind holds the tree's vertices in one shot: thin and far parts sway most, up to about
// `amplitude` metres at the top. `gust` picks the moment.
std::vector<glm::vec3> wind_blown(const Tree& tree, double amplitude, std::uint64_t gust);

}  // namespace bosk
