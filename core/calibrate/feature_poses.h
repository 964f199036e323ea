#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/bundle.h"
#include "core/photo/camera.h"

namespace bosk {

// Cameras and points from matches alone, in a world of arbitrary place, turn and scale.
struct FeaturePoses {
  Lens lens;
  std::vector<std::optional<RigidTransform>> camera_from_world;
  std::vector<std::optional<glm::dvec3>> points;
  std::vector<bool> agrees;  // beside the sightings: of a placed camera and point, and near it
};

// Incremental structure from motion (Schoenberger and Frahm 2016, "Structure-from-motion
// revisited", in outline): a pair with parallax, then the camera that sees most points, again and
// again, with bundle adjustment in between. `sightings` are sorted by camera. A lens that isn't
// known is freed as photos come in: focal length from the third, radial distortion from the fifth.
FeaturePoses place_by_features(const std::vector<BundleSighting>& sightings, std::size_t cameras,
                               std::size_t points, const Lens& lens, bool lens_known,
                               Progress& progress);

}  // namespace bosk
