#pragma once

#include <optional>
#include <vector>

#include "core/calibrate/bundle.h"
#include "core/calibrate/seed_pose.h"
#include "core/photo/camera.h"

namespace bosk {

// What seeds start from: a problem, its sightings' directions through the lens as it is guessed,
// and the sightings of each camera and point, as indices.
struct SeedScene {
  const BundleProblem* problem = nullptr;
  std::vector<double> intrinsics;
  std::vector<std::optional<glm::dvec3>> bearings;
  std::vector<std::vector<std::size_t>> of_camera, of_point;
  double focal_px = 1.0;

  std::size_t cameras() const { return of_camera.size(); }
  std::size_t points() const { return of_point.size(); }
  const BundleSighting& sighting(std::size_t i) const { return problem->sightings[i]; }
};

SeedScene seed_scene(const BundleProblem& problem, const std::vector<double>& intrinsics,
                     const Lens& lens, std::size_t cameras, std::size_t points);

// Cameras and points of which some are known so far.
struct PartialScene {
  std::vector<std::optional<RigidTransform>> camera_from_world;
  std::vector<std::optional<glm::dvec3>> points;
};

// The point nearest to the rays of the placed cameras that see it, doubting those that miss it by
// far; none where fewer than two do, or all look the same way (within a degree).
std::optional<glm::dvec3> seed_point(const SeedScene& scene, const PartialScene& partial,
                                     std::size_t point);

// The known points that a camera sees.
std::vector<PoseSighting> pose_sightings(const SeedScene& scene, const PartialScene& partial,
                                         std::size_t camera);

// Places what can be placed, the best seen first, adjusting as it goes. The first pose of each
// camera, where there is one, is kept as a beginning.
PartialScene grown(const SeedScene& scene, PartialScene partial, const Progress& progress);

// A state with all cameras and points; what isn't known stands beside its neighbour, or before the
// cameras that see it.
BundleState completed(const SeedScene& scene, const PartialScene& partial);

}  // namespace bosk
