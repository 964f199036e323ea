#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibrate/sightings.h"
#include "core/photo/camera.h"

namespace bosk {

// Faults of photos that show without solving. Each adds the reason of a photo that isn't refused
// yet.

// A size other than the lens's.
void refuse_other_sizes(std::span<const PhotoSightings> photos, const Lens& lens,
                        std::vector<std::string>& refused);
// Four or more sightings at the same pixels as in an earlier photo, and nothing much besides: two
// photos from one tripod differ by their noise, copies don't.
void refuse_copies(std::span<const PhotoSightings> photos, std::vector<std::string>& refused);

// Whether, in most photos, all points lie on one straight line but for mistakes.
bool points_on_a_line(std::span<const PhotoSightings> photos,
                      const std::vector<std::string>& refused);

}  // namespace bosk
