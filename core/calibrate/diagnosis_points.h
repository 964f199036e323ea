#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibrate/solve_input.h"

namespace bosk {

// What sightings that were left out have in common, a sentence each with the remedy: two names
// exchanged in a photo, a point that lay elsewhere in some photos.
std::vector<std::string> swapped_names(const SolveInput& input, const BundleState& state,
                                       std::span<const PhotoSightings> photos, double loss_scale);
std::vector<std::string> moved_points(const SolveInput& input, const BundleState& state,
                                      std::span<const PhotoSightings> photos, double loss_scale,
                                      bool scale_known);

}  // namespace bosk
