#pragma once

#include <string>
#include <vector>

#include "core/photo/camera.h"

extern "C" {
#include <mrcal/mrcal.h>
}

namespace bosk {

// Lenses as mrcal takes them: fx fy cx cy, then the distortion of its model, whose order is
// OpenCV's. Both count pixels from the centre of the first one. For the files of this folder alone.

enum class LensFamily { pinhole, opencv4, opencv5, opencv8 };

mrcal_lensmodel_t mrcal_model(LensFamily family);
int distortion_count(LensFamily family);
// The smallest family that holds the lens. Throws Error for a fisheye.
LensFamily family_of(const Lens& lens);

// `lens` may have fewer terms than the family; the others are 0.
std::vector<double> mrcal_intrinsics(const Lens& lens, LensFamily family);
Lens lens_of(LensFamily family, const std::vector<double>& intrinsics, int width_px, int height_px);

mrcal_pose_t mrcal_pose(const RigidTransform& transform);
RigidTransform transform_of(const mrcal_pose_t& pose);

}  // namespace bosk
