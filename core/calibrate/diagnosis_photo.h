#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/calibrate/bundle.h"
#include "core/photo/camera.h"

namespace bosk {

// A photo's sighting of a point whose place the other photos agree on.
struct KnownSighting {
  std::string point;
  glm::dvec3 in_world{0.0};
  glm::dvec2 pixel{0.0};
  double sigma_px = 0.5;
};

// Why a photo doesn't fit the others, as a clause with the remedy: whichever of mirrored, two names
// exchanged, cropped, other focal length, a few points misplaced, makes most of its sightings fit
// within `loss_scale` sigmas; else that it shows something else. `exif_focal_ratio` is what EXIF
// says of its focal length, relative to the other photos'.
std::string why_photo_disagrees(std::span<const KnownSighting> sightings, const Lens& lens,
                                double loss_scale, std::optional<double> exif_focal_ratio);

}  // namespace bosk
