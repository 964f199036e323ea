#include "core/phantom/tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace bosk {
namespace {

int sides_for(double radius) { return std::clamp(int(3.0 + radius * 120.0), 3, 14); }

glm::dvec3 any_perpendicular(const glm::dvec3& direction) {
  const glm::dvec3 other = std::abs(direction.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(direction, other));
}

glm::dvec3 direction_at(const std::vector<TubePoint>& line, std::size_t i) {
  const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, line.size() - 1);
  const glm::dvec3 along = line[after].position - line[before].position;
  const double length = glm::length(along);
  return length > 1e-9 ? along / length : glm::dvec3(0, 0, 1);
}

void add_ring(const TubePoint& point, const glm::dvec3& across, const glm::dvec3& along, int sides,
              TubeMesh& mesh) {
  const glm::dvec3 up = glm::cross(along, across);
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * glm::pi<double>() * k / sides;
    const glm::dvec3 normal = std::cos(angle) * across + std::sin(angle) * up;
    mesh.vertices.emplace_back(point.position + point.radius * normal);
    mesh.normals.emplace_back(normal);
    mesh.anchors.emplace_back(point.position);
  }
}

void join_rings(std::uint32_t first, int sides, TubeMesh& mesh) {
  const auto n = std::uint32_t(sides);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t a = first + k, b = first + (k + 1) % n;
    mesh.triangles.emplace_back(a, b, b + n);
    mesh.triangles.emplace_back(a, b + n, a + n);
  }
}

}  // namespace

void add_tube(const std::vector<TubePoint>& line, TubeMesh& mesh) {
  assert(line.size() > 1);
  const int sides = sides_for(line.front().radius);
  glm::dvec3 across = any_perpendicular(direction_at(line, 0));
  for (std::size_t i = 0; i < line.size(); ++i) {
    const glm::dvec3 along = direction_at(line, i);
    // Carry the frame along without twist.
    const glm::dvec3 carried = across - glm::dot(across, along) * along;
    across = glm::length(carried) > 1e-6 ? glm::normalize(carried) : any_perpendicular(along);
    TubePoint point = line[i];
    if (i + 1 == line.size()) point.radius *= 0.3;
    if (i > 0) join_rings(std::uint32_t(mesh.vertices.size()) - std::uint32_t(sides), sides, mesh);
    add_ring(point, across, along, sides, mesh);
  }
}

}  // namespace bosk
