#include "core/calibrate/mrcal_lens.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

Lens phone() {
  Lens lens;
  lens.model = LensModel::opencv;
  lens.width_px = 1414;
  lens.height_px = 1061;
  lens.focal_px = {1067.0, 1071.2};
  lens.principal_px = {718.2, 525.5};
  lens.distortion = {0.21, -0.9, 1e-3, -2e-3, 0.7, 0.05, -0.02, 0.01};
  return lens;
}

TEST(MrcalLens, ProjectsAsOursDoes) {
  for (const std::size_t used : {0u, 4u, 5u, 8u}) {
    Lens lens = phone();
    for (std::size_t i = used; i < 8; ++i) lens.distortion[i] = 0.0;
    const LensFamily family = family_of(lens);
    ASSERT_EQ(distortion_count(family), int(used));
    const mrcal_lensmodel_t model = mrcal_model(family);
    const std::vector<double> intrinsics = mrcal_intrinsics(lens, family);
    for (const glm::dvec3& point : {glm::dvec3(0.3, -0.2, 1.0), glm::dvec3(-0.9, 0.7, 2.5)}) {
      mrcal_point3_t in_camera{};
      for (int axis = 0; axis < 3; ++axis) in_camera.xyz[axis] = point[axis];
      mrcal_point2_t pixel{};
      ASSERT_TRUE(
          mrcal_project(&pixel, nullptr, nullptr, &in_camera, 1, &model, intrinsics.data()));
      const auto ours = pixel_from_camera(lens, point);
      ASSERT_TRUE(ours);
      EXPECT_NEAR(pixel.x, ours->x, 1e-9);
      EXPECT_NEAR(pixel.y, ours->y, 1e-9);
    }
    Lens back = lens_of(family, intrinsics, lens.width_px, lens.height_px);
    if (used > 0) {
      EXPECT_EQ(back, lens);
    }
  }
}

TEST(MrcalLens, PosesGoOutAndBack) {
  const RigidTransform pose{rotation_from_rodrigues({0.4, -1.1, 0.3}), {1.0, -2.0, 5.0}};
  const RigidTransform back = transform_of(mrcal_pose(pose));
  EXPECT_LT(glm::length(back.translation - pose.translation), 1e-12);
  EXPECT_LT(glm::length((back * glm::dvec3(3, 2, 1)) - (pose * glm::dvec3(3, 2, 1))), 1e-12);
}

TEST(MrcalLens, AFisheyeIsRefusedInWords) {
  Lens lens;
  lens.model = LensModel::opencv_fisheye;
  EXPECT_THROW(family_of(lens), Error);
}

}  // namespace
}  // namespace bosk
