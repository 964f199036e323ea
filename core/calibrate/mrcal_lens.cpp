#include "core/calibrate/mrcal_lens.h"

#include <algorithm>
#include <cassert>

#include "core/base/error.h"
#include "core/geometry/rotation.h"

namespace bosk {

mrcal_lensmodel_t mrcal_model(LensFamily family) {
  mrcal_lensmodel_t model{};
  switch (family) {
    case LensFamily::pinhole:
      model.type = MRCAL_LENSMODEL_PINHOLE;
      break;
    case LensFamily::opencv4:
      model.type = MRCAL_LENSMODEL_OPENCV4;
      break;
    case LensFamily::opencv5:
      model.type = MRCAL_LENSMODEL_OPENCV5;
      break;
    case LensFamily::opencv8:
      model.type = MRCAL_LENSMODEL_OPENCV8;
      break;
  }
  return model;
}

int distortion_count(LensFamily family) {
  switch (family) {
    case LensFamily::pinhole:
      return 0;
    case LensFamily::opencv4:
      return 4;
    case LensFamily::opencv5:
      return 5;
    case LensFamily::opencv8:
      break;
  }
  return 8;
}

LensFamily family_of(const Lens& lens) {
  if (lens.model == LensModel::opencv_fisheye) {
    throw Error(
        "calibration knows no fisheye lenses; give its cameras as a file, or photograph with an "
        "ordinary lens");
  }
  std::size_t used = lens.distortion.size();
  while (used > 0 && lens.distortion[used - 1] == 0.0) --used;
  if (used == 0) return LensFamily::pinhole;
  if (used <= 4) return LensFamily::opencv4;
  return used == 5 ? LensFamily::opencv5 : LensFamily::opencv8;
}

std::vector<double> mrcal_intrinsics(const Lens& lens, LensFamily family) {
  std::vector<double> intrinsics{lens.focal_px.x, lens.focal_px.y, lens.principal_px.x,
                                 lens.principal_px.y};
  intrinsics.insert(intrinsics.end(), lens.distortion.begin(),
                    lens.distortion.begin() + distortion_count(family));
  return intrinsics;
}

Lens lens_of(LensFamily family, const std::vector<double>& intrinsics, int width_px,
             int height_px) {
  assert(intrinsics.size() == std::size_t(4 + distortion_count(family)));
  Lens lens;
  lens.model = family == LensFamily::pinhole ? LensModel::pinhole : LensModel::opencv;
  lens.width_px = width_px;
  lens.height_px = height_px;
  lens.focal_px = {intrinsics[0], intrinsics[1]};
  lens.principal_px = {intrinsics[2], intrinsics[3]};
  std::copy(intrinsics.begin() + 4, intrinsics.end(), lens.distortion.begin());
  return lens;
}

mrcal_pose_t mrcal_pose(const RigidTransform& transform) {
  const glm::dvec3 r = rodrigues_from_rotation(transform.rotation);
  mrcal_pose_t pose{};
  for (int axis = 0; axis < 3; ++axis) {
    pose.r.xyz[axis] = r[axis];
    pose.t.xyz[axis] = transform.translation[axis];
  }
  return pose;
}

RigidTransform transform_of(const mrcal_pose_t& pose) {
  return {rotation_from_rodrigues({pose.r.xyz[0], pose.r.xyz[1], pose.r.xyz[2]}),
          {pose.t.xyz[0], pose.t.xyz[1], pose.t.xyz[2]}};
}

}  // namespace bosk
