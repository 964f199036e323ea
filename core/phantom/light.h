#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/phantom/ray_scene.h"
#include "core/phantom/scene.h"
#include "core/phantom/tree.h"

namespace bosk {

// How much of the sun and of the sky reaches the ground round the tree: a square map that covers
// [-half_size, half_size] in x and y; beyond it both are whole.
struct GroundLight {
  float half_size = 1.0f;
  Image<float> sun, sky;
};

// Light that leaves the tree, computed once at rest: per facet of a leaf and side (radiance, with
// what shines through), per vertex of the wood (radiance over albedo). Sun with soft shadows, the
// sky and one bounce from ground and leaves, by ray casting.
struct TreeLight {
  std::vector<glm::vec3> facet_front, facet_back;
  std::vector<float> facet_sun;  // share of the sun that is visible
  std::vector<glm::vec3> wood;
};

GroundLight light_ground(const RayScene& tree, const World& world, int map_side,
                         Progress& progress);
TreeLight light_tree(const Tree& tree, const RayScene& rays, const World& world,
                     const GroundLight& ground, Progress& progress);

glm::vec3 ground_radiance(const World& world, const GroundLight& ground, const glm::vec2& point,
                          float footprint);
// Radiance of the tree where a ray along `direction` met it.
glm::vec3 tree_radiance(const Tree& tree, const TreeLight& light, const World& world,
                        const RayHit& hit, const glm::vec3& direction);
// Radiance of a ball, stick or board.
glm::vec3 solid_radiance(const World& world, const RayScene& tree, const SolidHit& hit,
                         const glm::vec3& point);

}  // namespace bosk
