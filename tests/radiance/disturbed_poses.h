#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/rigid_transform.h"
#include "core/photo/photo.h"

namespace bosk {

// Each camera turned about its own axes: the picture moves by `error_px` (one sigma along each
// axis) and rolls by the same angle.
Photos disturbed(Photos photos, double error_px, std::uint64_t seed);

std::vector<RigidTransform> poses_of(const Photos& photos);

// Of the box's corners as seen by all photos with these poses, against the photos' own, after the
// best alignment of the worlds; pixels.
double rms_px(const Photos& truth, const std::vector<RigidTransform>& poses, const Box& crown);

}  // namespace bosk
