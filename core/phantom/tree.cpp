#include "core/phantom/tree.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/random.h"
#include "core/phantom/leaves.h"
#include "core/phantom/noise.h"
#include "core/phantom/tube.h"

namespace bosk {
namespace {

constexpr int kNone = -1;

// The thickest child of each node continues its branch; the others begin one.
std::vector<int> thickest_children(const std::vector<SkeletonNode>& nodes) {
  std::vector<int> thickest(nodes.size(), kNone);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    int& best = thickest[std::size_t(nodes[i].parent)];
    if (best == kNone || nodes[i].radius > nodes[std::size_t(best)].radius) best = int(i);
  }
  return thickest;
}

void add_branches(const std::vector<SkeletonNode>& nodes, TubeMesh& wood) {
  const std::vector<int> thickest = thickest_children(nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int parent = nodes[i].parent;
    if (parent != kNone && thickest[std::size_t(parent)] == int(i)) continue;
    std::vector<TubePoint> line;
    if (parent != kNone) {
      // A branch leaves its bough from the axis, no thicker than it goes on.
      line.push_back({nodes[std::size_t(parent)].position, nodes[i].radius});
    }
    for (int node = int(i); node != kNone; node = thickest[std::size_t(node)]) {
      line.push_back({nodes[std::size_t(node)].position, nodes[std::size_t(node)].radius});
    }
    if (line.size() > 1) add_tube(line, wood);
  }
}

struct Shoot {
  glm::dvec3 from{0.0}, to{0.0};
};

std::vector<Shoot> place_shoots(const std::vector<SkeletonNode>& nodes, const TreeShape& shape,
                                Random& random) {
  const std::vector<int> thickest = thickest_children(nodes);
  std::vector<Shoot> shoots;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i].radius > shape.leaf_bearing_radius) continue;
    const glm::dvec3 from = nodes[i].position;
    const glm::dvec3 along = glm::normalize(from - nodes[std::size_t(nodes[i].parent)].position);
    const double wanted = shape.shoots_per_node * (thickest[i] == kNone ? 2.0 : 1.0);
    for (int k = int(wanted + random.uniform()); k > 0; --k) {
      glm::dvec3 side{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.7, 0.9)};
      const glm::dvec3 direction = glm::normalize(0.8 * along + side);
      shoots.push_back({from, from + shape.shoot_length * random.uniform(0.6, 1.25) * direction});
    }
  }
  return shoots;
}

void add_shoot_wood(const Shoot& shoot, const TreeShape& shape, Random& random, TubeMesh& wood) {
  const glm::dvec3 sag{random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06), 0.08};
  const glm::dvec3 middle = glm::mix(shoot.from, shoot.to, 0.5) + shape.shoot_length * sag;
  const double radius = 0.6 * shape.twig_radius;
  add_tube({{shoot.from, radius}, {middle, 0.8 * radius}, {shoot.to, 0.5 * radius}}, wood);
}

Tree assemble(const TreeShape& shape, TubeMesh wood, LeafMesh leaves) {
  Tree tree;
  tree.shape = shape;
  tree.wood_vertices = wood.vertices.size();
  tree.wood_triangles = wood.triangles.size();
  tree.vertices = std::move(wood.vertices);
  tree.triangles = std::move(wood.triangles);
  tree.wood_normals = std::move(wood.normals);
  tree.vertex_anchors = std::move(wood.anchors);
  tree.triangles_per_facet = leaves.triangles_per_facet;
  tree.facets_per_leaf = leaves.facets_per_leaf;
  const auto first = std::uint32_t(tree.wood_vertices);
  for (const glm::uvec3& triangle : leaves.triangles) tree.triangles.push_back(triangle + first);
  tree.vertices.insert(tree.vertices.end(), leaves.vertices.begin(), leaves.vertices.end());
  tree.vertex_anchors.insert(tree.vertex_anchors.end(), leaves.anchors.begin(),
                             leaves.anchors.end());
  return tree;
}

// Slow waves for boughs, quick ones for twigs; a function of the place alone, so nothing tears.
glm::vec3 sway_at(const glm::vec3& anchor, const Tree& tree, float amplitude,
                  const glm::vec3& phase) {
  const float height = float(tree.shape.height);
  const float up = std::max(anchor.z, 0.0f) / height;
  const float out = std::hypot(anchor.x, anchor.y) / height;
  const float reach = std::min(up * up + 1.5f * out * up, 1.2f);
  const auto wave = [&](float per_metre, float shift) {
    const glm::vec3 at = anchor * per_metre + phase + shift;
    return glm::vec3(value_noise(at), value_noise(at + 31.7f), value_noise(at + 71.3f)) - 0.5f;
  };
  const glm::vec3 lean = wave(0.15f, 0.0f) * glm::vec3(2.0f, 2.0f, 0.3f);
  return amplitude * reach * (lean + 0.9f * wave(1.3f, 11.0f));
}

}  // namespace

glm::vec3 Tree::normal(std::size_t triangle) const {
  const glm::uvec3 t = triangles[triangle];
  const glm::vec3 n = glm::cross(vertices[t.y] - vertices[t.x], vertices[t.z] - vertices[t.x]);
  const float length = glm::length(n);
  return length > 0.0f ? n / length : glm::vec3(0.0f);
}

glm::vec3 Tree::point(std::size_t triangle, float u, float v) const {
  const glm::uvec3 t = triangles[triangle];
  return (1.0f - u - v) * vertices[t.x] + u * vertices[t.y] + v * vertices[t.z];
}

Tree grow_tree(const TreeShape& shape, std::uint64_t seed, Progress& progress) {
  const std::vector<SkeletonNode> nodes = grow_skeleton(shape, seed, progress);
  TubeMesh wood;
  add_branches(nodes, wood);
  Random random(seed, 2);
  LeafMesh leaves = empty_leaf_mesh(shape.leaf_kind);
  for (const Shoot& shoot : place_shoots(nodes, shape, random)) {
    progress.check();
    add_shoot_wood(shoot, shape, random, wood);
    add_leaves_along(shoot.from, shoot.to, shape, random, leaves);
  }
  return assemble(shape, std::move(wood), std::move(leaves));
}

std::vector<glm::vec3> wind_blown(const Tree& tree, double amplitude, std::uint64_t gust) {
  Random random(gust, 3);
  const auto draw = [&] { return float(random.uniform(0.0, 1000.0)); };
  const glm::vec3 phase{draw(), draw(), draw()};
  std::vector<glm::vec3> moved = tree.vertices;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i] += sway_at(tree.vertex_anchors[i], tree, float(amplitude), phase);
  }
  return moved;
}

}  // namespace bosk
