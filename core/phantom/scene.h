#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/phantom/ray_scene.h"

namespace bosk {

// A coloured ball on a stick, for calibration.
struct Marker {
  std::string name;
  glm::u8vec3 colour_srgb{0};
  glm::dvec3 centre{0.0};
  double radius = 0.11;
};

// A chessboard: `columns` x `rows` squares and a white rim one square wide. Its frame: x along the
// columns, y along the rows, z out of the face, origin at the first inner corner.
struct Board {
  RigidTransform world_from_board;
  int columns = 11, rows = 8;
  double square = 0.06;
};

// All that surrounds the tree. Radiances are linear RGB where 1 is what a photograph shows as
// white.
struct World {
  std::uint32_t seed = 1;
  glm::vec3 sun_direction{0.0f, 0.0f, 1.0f};  // towards the sun
  glm::vec3 sun_light{1.75f, 1.62f, 1.4f};    // radiance of a white wall that faces the sun
  float tree_height = 10.0f, crown_radius = 5.0f;
  std::vector<Marker> markers;
  std::vector<Board> boards;
  std::vector<MeshCopy> distant_trees;
};

// The first marker, stick or board along a ray.
struct SolidHit {
  float distance = 1e30f;
  glm::vec3 normal{0.0f}, albedo{0.0f};

  explicit operator bool() const { return distance < 1e30f; }
};

glm::vec3 sky_radiance(const World& world, const glm::vec3& direction);
// What the sky's light falls back to where nobody computed it: the mean over the upper half.
glm::vec3 mean_sky_radiance();
// Colour of the ground; `footprint` is the size of a pixel there, finer pattern is left out.
glm::vec3 ground_albedo(const World& world, const glm::vec2& point, float footprint);
// Share of the sun that the crowns of the distant trees leave for the ground.
float distant_shadow(const World& world, const glm::vec2& point);
SolidHit solid_along(const World& world, const glm::vec3& origin, const glm::vec3& direction);
// Light scattered into the view by `distance` metres of air.
glm::vec3 through_haze(const glm::vec3& radiance, float distance);

std::vector<Marker> place_markers(int count, double crown_radius, double scale, std::uint64_t seed);
std::vector<MeshCopy> place_distant_trees(int count, double tree_height, std::uint64_t seed);

}  // namespace bosk
