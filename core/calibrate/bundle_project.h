#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/calibrate/bundle.h"

namespace bosk {

// The sightings of one camera, projected in one call of mrcal. Arrays are in the sightings' order.
struct ProjectedSightings {
  std::vector<bool> in_front;
  std::vector<glm::dvec3> in_camera;
  std::vector<mrcal_point2_t> pixel;
  std::vector<std::array<mrcal_point3_t, 2>> by_point;  // d pixel / d in_camera
  std::vector<double> by_lens;                          // 2 x intrinsics each
};

// Nearer than this to the camera's plane, in the world's unit, counts as behind it.
inline constexpr double kLeastDepth = 1e-3;

// Derivatives are left out unless asked for.
ProjectedSightings project_sightings(const BundleProblem& problem, const BundleState& state,
                                     std::span<const BundleSighting> of_one_camera,
                                     bool derivatives);

// The sightings, camera by camera.
std::vector<std::span<const BundleSighting>> by_camera(const BundleProblem& problem);

}  // namespace bosk
