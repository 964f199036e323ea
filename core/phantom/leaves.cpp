#include "core/phantom/leaves.h"

#include <cmath>

namespace bosk {
namespace {

constexpr double kFanCentre = 0.45;
constexpr double kGoldenAngle = 2.399963229728653;

// Where a leaf stands: its foot, the way it points, its blade's normal.
struct LeafPose {
  glm::dvec3 foot{0.0}, along{1, 0, 0}, normal{0, 0, 1};
  double length = 0.1, width = 0.06, fold = 0.3, curl = 0.1;
};

// Half outlines in units of length and half width, foot and tip left out.
std::vector<glm::vec2> half_outline(LeafKind kind) {
  switch (kind) {
    case LeafKind::lobed:
      return {{0.22f, 0.55f}, {0.34f, 0.42f}, {0.52f, 1.0f}, {0.66f, 0.55f}, {0.84f, 0.62f}};
    case LeafKind::ovate:
      return {{0.2f, 0.75f}, {0.42f, 1.0f}, {0.75f, 0.55f}};
    case LeafKind::needle:
      break;
  }
  return {{0.5f, 1.0f}};
}

glm::dvec3 blade_point(const LeafPose& pose, double along, double across) {
  const glm::dvec3 side = glm::cross(pose.normal, pose.along);
  const double lift =
      pose.fold * std::abs(across) * pose.width * 0.5 - pose.curl * along * along * pose.length;
  return pose.foot + along * pose.length * pose.along + across * 0.5 * pose.width * side +
         lift * pose.normal;
}

// Each half is a fan round the middle of the midrib (a needle's round its foot); the left one turns
// the other way round so that fronts agree.
void add_blade(const LeafPose& pose, LeafMesh& mesh) {
  const auto first = std::uint32_t(mesh.vertices.size());
  const auto count = std::uint32_t(mesh.outline.size());
  const auto put = [&](double along, double across) {
    mesh.vertices.emplace_back(blade_point(pose, along, across));
    mesh.anchors.emplace_back(pose.foot);
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool left) {
    left ? mesh.triangles.emplace_back(a, b, c) : mesh.triangles.emplace_back(a, c, b);
  };
  put(0.0, 0.0);
  put(1.0, 0.0);
  const bool needle = count == 1;
  if (!needle) put(kFanCentre, 0.0);
  const std::uint32_t centre = needle ? first : first + 2;
  for (const double side : {1.0, -1.0}) {
    const auto base = std::uint32_t(mesh.vertices.size());
    for (const glm::vec2& p : mesh.outline) put(p.x, side * p.y);
    if (!needle) add(centre, base, first, side < 0.0);
    for (std::uint32_t k = 0; k < count; ++k) {
      add(centre, k + 1 < count ? base + k + 1 : first + 1, base + k, side < 0.0);
    }
  }
}

glm::dvec3 random_offset(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

LeafPose broad_pose(const glm::dvec3& foot, const glm::dvec3& side, const glm::dvec3& shoot,
                    const TreeShape& shape, Random& random) {
  LeafPose pose;
  const glm::dvec3 down{0.0, 0.0, -shape.leaf_droop};
  pose.along = glm::normalize(side + 0.55 * shoot + down + random_offset(random, 0.45));
  // A petiole holds the blade off the shoot, and the blade turns its face to the sky, loosely.
  pose.foot = foot + 0.25 * shape.leaf_length * glm::normalize(side + 0.3 * shoot);
  const glm::dvec3 sky = glm::dvec3(0, 0, 1) + random_offset(random, 0.75);
  const glm::dvec3 upright = sky - glm::dot(sky, pose.along) * pose.along;
  pose.normal = glm::length(upright) > 1e-3 ? glm::normalize(upright) : glm::normalize(shoot);
  const double size = random.uniform(0.7, 1.2);
  pose.length = shape.leaf_length * size;
  pose.width = shape.leaf_width * size;
  pose.fold = random.uniform(0.1, 0.6);
  pose.curl = random.uniform(0.0, 0.3);
  return pose;
}

LeafPose needle_pose(const glm::dvec3& foot, const glm::dvec3& side, const glm::dvec3& shoot,
                     const TreeShape& shape, Random& random) {
  LeafPose pose;
  pose.foot = foot;
  pose.along = glm::normalize(side + 0.7 * shoot + random_offset(random, 0.25));
  pose.normal =
      glm::normalize(glm::cross(pose.along, side + random_offset(random, 0.5)) + glm::dvec3(1e-6));
  pose.normal = glm::normalize(pose.normal - glm::dot(pose.normal, pose.along) * pose.along);
  pose.length = shape.leaf_length * random.uniform(0.75, 1.15);
  pose.width = shape.leaf_width;
  pose.fold = pose.curl = 0.0;
  return pose;
}

}  // namespace

LeafMesh empty_leaf_mesh(LeafKind kind) {
  LeafMesh mesh;
  mesh.outline = half_outline(kind);
  const bool needle = kind == LeafKind::needle;
  mesh.facets_per_leaf = needle ? 1 : 2;
  mesh.triangles_per_facet = needle ? 2 : mesh.outline.size() + 1;
  return mesh;
}

void add_leaves_along(const glm::dvec3& from, const glm::dvec3& to, const TreeShape& shape,
                      Random& random, LeafMesh& mesh) {
  const glm::dvec3 shoot = glm::normalize(to - from);
  const glm::dvec3 helper = std::abs(shoot.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(shoot, helper));
  const glm::dvec3 up = glm::cross(shoot, across);
  double angle = random.uniform(0.0, 6.283185307);
  const bool needle = shape.leaf_kind == LeafKind::needle;
  for (int k = 0; k < shape.leaves_per_shoot; ++k) {
    angle += kGoldenAngle + random.uniform(-0.3, 0.3);
    const double t = (k + random.uniform(0.3, 1.0)) / shape.leaves_per_shoot;
    const glm::dvec3 foot = glm::mix(from, to, t);
    const glm::dvec3 side = std::cos(angle) * across + std::sin(angle) * up;
    add_blade(needle ? needle_pose(foot, side, shoot, shape, random)
                     : broad_pose(foot, side, shoot, shape, random),
              mesh);
  }
}

}  // namespace bosk
