#include "core/phantom/skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/phantom/noise.h"

namespace bosk {
namespace {

constexpr int kMaxRounds = 400;
constexpr int kMaxChildren = 3;

glm::dvec3 random_direction(Random& random) {
  while (true) {
    const glm::dvec3 point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double square = glm::dot(point, point);
    if (square > 1e-4 && square <= 1.0) return point / std::sqrt(square);
  }
}

// Whether a point lies in the crown; the noise makes boughs and bays in its surface.
bool inside_crown(const TreeShape& shape, const glm::dvec3& point, double noise_shift,
                  double& depth) {
  const double radius = envelope_radius(shape, point.z);
  const glm::vec3 at = glm::vec3(point / shape.height * 5.0) + float(noise_shift);
  const double lumpy = radius * (1.0 + shape.envelope_lumps * 2.0 * (value_noise(at) - 0.7));
  const double distance = std::hypot(point.x, point.y);
  depth = lumpy > 0.0 ? distance / lumpy : 2.0;
  return depth <= 1.0;
}

std::vector<glm::dvec3> scatter_attractors(const TreeShape& shape, Random& random) {
  const double reach = *std::max_element(shape.radius_profile.begin(), shape.radius_profile.end());
  const double noise_shift = random.uniform(0.0, 100.0);
  std::vector<glm::dvec3> points;
  while (points.size() < std::size_t(shape.attractors)) {
    const glm::dvec3 point{random.uniform(-reach, reach), random.uniform(-reach, reach),
                           random.uniform(shape.crown_base, shape.height)};
    double depth = 0.0;
    if (!inside_crown(shape, point, noise_shift, depth)) continue;
    if (random.uniform() < shape.rind * (1.0 - depth * depth)) continue;
    points.push_back(point);
  }
  return points;
}

// Points sorted into cubic cells as large as the search radius.
class PointGrid {
 public:
  PointGrid(const std::vector<glm::dvec3>& points, double cell) : cell_(cell) {
    lower_ = upper_ = points.front();
    for (const auto& point : points) {
      lower_ = glm::min(lower_, point);
      upper_ = glm::max(upper_, point);
    }
    size_ = glm::ivec3((upper_ - lower_) / cell_) + 1;
    lists_.resize(std::size_t(size_.x) * std::size_t(size_.y) * std::size_t(size_.z));
    for (std::size_t i = 0; i < points.size(); ++i)
      lists_[index(cell_of(points[i]))].push_back(int(i));
  }

  template <class Visit>
  void near(const glm::dvec3& point, Visit&& visit) const {
    const glm::ivec3 centre = cell_of(point);
    const glm::ivec3 first = glm::max(centre - 1, 0), last = glm::min(centre + 1, size_ - 1);
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
          for (const int i : lists_[index({x, y, z})]) visit(i);
  }

 private:
  glm::ivec3 cell_of(const glm::dvec3& point) const {
    return glm::ivec3(glm::floor((point - lower_) / cell_));
  }
  std::size_t index(const glm::ivec3& c) const {
    return (std::size_t(c.z) * std::size_t(size_.y) + std::size_t(c.y)) * std::size_t(size_.x) +
           std::size_t(c.x);
  }
  double cell_;
  glm::dvec3 lower_{0.0}, upper_{0.0};
  glm::ivec3 size_{1};
  std::vector<std::vector<int>> lists_;
};

struct Growth {
  std::vector<SkeletonNode> nodes;
  std::vector<std::array<int, kMaxChildren>> children;  // -1 where none
  std::vector<glm::dvec3> attractors;
  std::vector<int> nearest;  // node of each attractor; -1 none within reach, -2 attractor gone
  std::vector<double> distance;
};

void add_node(Growth& growth, const PointGrid& grid, const TreeShape& shape,
              const glm::dvec3& position, int parent) {
  const int node = int(growth.nodes.size());
  growth.nodes.push_back({position, parent, 0.0});
  growth.children.push_back({-1, -1, -1});
  if (parent >= 0) {
    auto& slots = growth.children[std::size_t(parent)];
    *std::find(slots.begin(), slots.end(), -1) = node;
  }
  grid.near(position, [&](int i) {
    const auto attractor = std::size_t(i);
    if (growth.nearest[attractor] == -2) return;
    const double distance = glm::distance(growth.attractors[attractor], position);
    if (distance < shape.kill) {
      growth.nearest[attractor] = -2;
    } else if (distance < growth.distance[attractor]) {
      growth.nearest[attractor] = node;
      growth.distance[attractor] = distance;
    }
  });
}

// A node may not grow where it, or a child of it, already stands.
bool room_for(const Growth& growth, std::size_t node, const glm::dvec3& position, double step) {
  const auto& slots = growth.children[node];
  if (slots.back() >= 0) return false;
  return std::all_of(slots.begin(), slots.end(), [&](int child) {
    return child < 0 ||
           glm::distance(growth.nodes[std::size_t(child)].position, position) > 0.45 * step;
  });
}

void grow_trunk(Growth& growth, const PointGrid& grid, const TreeShape& shape, Random& random) {
  glm::dvec3 position{0.0};
  add_node(growth, grid, shape, position, -1);
  glm::dvec3 lean = 0.05 * random_direction(random);
  while (position.z < shape.leader_height) {
    lean += 0.04 * random_direction(random) - 0.1 * lean;
    const glm::dvec3 home{-position.x, -position.y, 0.0};
    position +=
        shape.step * glm::normalize(glm::dvec3(0, 0, 1) + lean * glm::dvec3(1, 1, 0) + 0.35 * home);
    add_node(growth, grid, shape, position, int(growth.nodes.size()) - 1);
  }
}

// One round: each node that attractors are nearest to grows a step towards their mean direction.
bool grow_round(Growth& growth, const PointGrid& grid, const TreeShape& shape, Random& random) {
  std::vector<glm::dvec3> pull(growth.nodes.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i < growth.attractors.size(); ++i) {
    if (growth.nearest[i] < 0) continue;
    const auto node = std::size_t(growth.nearest[i]);
    pull[node] += glm::normalize(growth.attractors[i] - growth.nodes[node].position);
  }
  bool grew = false;
  for (std::size_t node = 0; node < pull.size(); ++node) {
    if (pull[node] == glm::dvec3(0.0)) continue;
    glm::dvec3 direction =
        glm::normalize(pull[node]) + shape.tropism + shape.wobble * random_direction(random);
    if (glm::length(direction) < 0.2) direction = random_direction(random);
    const glm::dvec3 position =
        growth.nodes[node].position + shape.step * glm::normalize(direction);
    if (position.z < 0.25 * shape.crown_base || !room_for(growth, node, position, shape.step))
      continue;
    add_node(growth, grid, shape, position, int(node));
    grew = true;
  }
  return grew;
}

void smooth(Growth& growth) {
  auto& nodes = growth.nodes;
  const std::vector<SkeletonNode> before = nodes;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const int child = growth.children[i][0];
    if (child < 0) continue;
    const glm::dvec3 middle =
        0.5 * (before[std::size_t(nodes[i].parent)].position + before[std::size_t(child)].position);
    nodes[i].position = glm::mix(nodes[i].position, middle, 0.5);
  }
}

void set_radii(std::vector<SkeletonNode>& nodes, const TreeShape& shape) {
  const double n = shape.pipe_exponent;
  std::vector<double> pipes(nodes.size(), 0.0);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (pipes[i] == 0.0) pipes[i] = std::pow(shape.twig_radius, n);
    nodes[i].radius = std::pow(pipes[i], 1.0 / n);
    if (nodes[i].parent >= 0) pipes[std::size_t(nodes[i].parent)] += pipes[i];
    const double flare_height = 0.035 * shape.height;
    nodes[i].radius *= 1.0 + shape.trunk_flare * std::exp(-nodes[i].position.z / flare_height) *
                                 (nodes[i].position.z < 4.0 * flare_height ? 1.0 : 0.0);
  }
}

}  // namespace

std::vector<SkeletonNode> grow_skeleton(const TreeShape& shape, std::uint64_t seed,
                                        Progress& progress) {
  Random random(seed, 1);
  Growth growth;
  growth.attractors = scatter_attractors(shape, random);
  growth.nearest.assign(growth.attractors.size(), -1);
  growth.distance.assign(growth.attractors.size(), shape.influence);
  const PointGrid grid(growth.attractors, shape.influence);
  grow_trunk(growth, grid, shape, random);
  for (int round = 0; round < kMaxRounds && grow_round(growth, grid, shape, random); ++round) {
    progress.check();
  }
  smooth(growth);
  smooth(growth);
  set_radii(growth.nodes, shape);
  return growth.nodes;
}

}  // namespace bosk
