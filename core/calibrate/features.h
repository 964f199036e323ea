#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/sightings.h"
#include "core/geometry/rigid_transform.h"
#include "core/image/image.h"
#include "core/photo/camera.h"

namespace bosk {

// A photo to find features in. Both images outlive the call.
struct FeaturePhoto {
  std::string name;
  const Image<glm::vec3>* srgb = nullptr;  // sRGB, 0 to 1
  const Image<std::uint8_t>* mask =
      nullptr;  // as large; features only where it isn't 0; none: everywhere
};

struct FeatureOptions {
  int features_per_photo = 4000;  // 100 to 20000, the strongest
  double ratio = 0.8;             // 0.5 to 1: distance of the best match over the second best
  double largest_error_px = 3.0;  // of a match, from its epipolar line
  int fewest_matches = 20;        // of a pair of photos that counts
  int tracks_per_photo = 300;     // 50 to 5000, the longest
};

// What features alone say. `photos` runs beside the input; points are named "f12". Of the photos
// that could be placed there are first poses, in a world of arbitrary place, turn and scale.
struct FeatureSightings {
  std::vector<PhotoSightings> photos;
  std::vector<std::optional<RigidTransform>> camera_from_world;
  Lens lens;                           // as guessed, or refined together with the poses
  std::vector<std::string> sentences;  // what went wrong, and the remedy
};

// SIFT features, matched between photos and chained into tracks; first poses from essential
// matrices, PnP and triangulation. `lens` is that of all photos; its focal length is refined unless
// `lens_known`. The photos stand in the order of the walk, all of one size. Throws Cancelled.
FeatureSightings find_features(std::span<const FeaturePhoto> photos, const Lens& lens,
                               bool lens_known, const FeatureOptions& options, Progress& progress);

}  // namespace bosk
