#pragma once

#include <optional>
#include <vector>

#include "core/calibrate/seed_scene.h"

namespace bosk {

// Two photos to begin with: the second camera relative to the first, a unit apart.
struct FeaturePair {
  int first = 0, second = 0;
  RigidTransform second_from_first;
  double worth = 0.0;
};

// Pairs whose essential matrix (Nister 2004, by OpenCV) gives many points a good angle, the best
// first. `scene` holds the bearings through the lens as it is guessed.
std::vector<FeaturePair> starting_pairs(const SeedScene& scene, const Progress& progress);

// The pose that most known points agree with (P3P in RANSAC, by OpenCV); none with fewer than
// `fewest`, or fewer than a quarter of them.
std::optional<RigidTransform> pose_by_points(const SeedScene& scene, const PartialScene& partial,
                                             int camera, double error_px, std::size_t fewest);

}  // namespace bosk
