#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/matte/hull.h"
#include "core/matte/stroke_model.h"
#include "core/photo/photo.h"

namespace bosk {

// The level ground that the tree stands on, as the photos show it.
struct Ground {
  double height_m = 0.0;  // world z
  // For each photo a coarse grid over it, 0 to 1: 1 where its colours are those that the other
  // photos show of the same places on the ground; 0 too where fewer than a third of them show
  // those.
  std::vector<Image<float>> likeness;
};

// Finds the height at which the photos agree best on the colours of places around the trunk.
// `samples` are every n-th pixel of every n-th row of each photo, all at one exposure. None where
// the cameras do not look from around, there are fewer than four, or no height stands out: a lawn
// without any marks, a slope, a table top that photos hardly show.
std::optional<Ground> find_ground(const Photos& photos, const std::vector<LabPlanes>& samples,
                                  Progress& progress);

// For each photo a grid of how much less likely opaque is (natural logarithm, kMostDoubt * weight
// to 0) because the photo shows the ground there, its shadow included. Where `volume` holds
// something that stands on that place, such as the trunk, nothing is said; without one all of the
// ground is taken for bare.
std::vector<Image<float>> ground_tilts(const Photos& photos, const Ground& ground,
                                       const std::optional<AgreedVolume>& volume, float weight,
                                       Progress& progress);

}  // namespace bosk
