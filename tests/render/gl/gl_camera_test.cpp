#include "core/render/gl/gl_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bosk {
namespace {

Lens wide_lens(LensModel model = LensModel::pinhole) {
  Lens lens;
  lens.model = model;
  lens.width_px = 640;
  lens.height_px = 480;
  lens.focal_px = {500.0, 510.0};
  lens.principal_px = {310.0, 250.5};
  return lens;
}

TEST(GlCamera, PutsPointsOnThePixelThatTheLensSeesThemAt) {
  const Lens lens = wide_lens();
  for (const glm::dvec3 point : {glm::dvec3(0, 0, 5), {1, -0.5, 3}, {-40, 25, 900}}) {
    const glm::dvec4 clip = gl_clip_from_camera(lens) * glm::dvec4(point, 1.0);
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const glm::dvec2 pixel((ndc.x + 1.0) / 2.0 * 640.0 - 0.5, (1.0 - ndc.y) / 2.0 * 480.0 - 0.5);
    EXPECT_LT(glm::distance(pixel, *pixel_from_camera(lens, point)), 1e-9);
    EXPECT_NEAR(ndc.z, 1.0 - 2.0 * kNear_m / point.z, 1e-12);
  }
}

TEST(GlCamera, TurnsOurAxesIntoOpenGls) {
  EXPECT_EQ(gl_camera_from_camera * glm::dvec4(1, 2, 3, 1), glm::dvec4(1, -2, -3, 1));
}

TEST(GlCamera, FindsWhereALensFoldsOver) {
  EXPECT_GT(lens_fold(wide_lens()), 1e15);
  Lens barrel = wide_lens(LensModel::opencv);
  barrel.distortion = {-0.25, 0.0, 0.01, 0.02};
  EXPECT_NEAR(lens_fold(barrel), 1.0 / (3.0 * 0.25), 1e-6);  // of r - 0.25 r^3
  Lens fisheye = wide_lens(LensModel::opencv_fisheye);
  EXPECT_GT(lens_fold(fisheye), 1.57);
  fisheye.distortion = {-0.3, 0.0, 0.0, 0.0};
  EXPECT_NEAR(lens_fold(fisheye), std::sqrt(1.0 / 0.9), 1e-6);
}

}  // namespace
}  // namespace bosk
