#include "core/photo/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <vector>

#include "tests/photo/random_cameras.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace testing_cameras;

// OpenCV and Bosk evaluate the same formula in doubles; pixels go up to 1e4, whose last bit is
// 2e-12.
constexpr double kSameFormula_px = 1e-9;

cv::Matx33d matrix_of(const Lens& lens) {
  return {
      lens.focal_px.x, 0, lens.principal_px.x, 0, lens.focal_px.y, lens.principal_px.y, 0, 0, 1};
}

dvec2 projected_by_opencv(const Lens& lens, const dvec3& point) {
  const std::vector<cv::Point3d> points{{point.x, point.y, point.z}};
  const cv::Vec3d zero(0, 0, 0);
  const auto& k = lens.distortion;
  std::vector<cv::Point2d> pixels;
  if (lens.model == LensModel::opencv_fisheye)
    cv::fisheye::projectPoints(points, pixels, zero, zero, matrix_of(lens),
                               cv::Vec4d(k[0], k[1], k[2], k[3]));
  else
    cv::projectPoints(points, zero, zero, matrix_of(lens), std::vector<double>(k.begin(), k.end()),
                      pixels);
  return {pixels[0].x, pixels[0].y};
}

class EveryLens : public ::testing::TestWithParam<LensModel> {};
INSTANTIATE_TEST_SUITE_P(Models, EveryLens,
                         ::testing::Values(LensModel::pinhole, LensModel::opencv,
                                           LensModel::opencv_fisheye));

TEST_P(EveryLens, ProjectsWhereOpenCvDoes) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Lens lens = random_lens(random, GetParam());
    const dvec3 point = random_point_in_camera(random);
    const auto pixel = pixel_from_camera(lens, point);
    ASSERT_TRUE(pixel) << i;
    EXPECT_LT(glm::length(*pixel - projected_by_opencv(lens, point)), kSameFormula_px) << i;
  }
}

TEST_P(EveryLens, InverseReturnsThePixel) {
  Random random(2);
  int answered = 0;
  for (int i = 0; i < 2000; ++i) {
    const Lens lens = random_lens(random, GetParam());
    const dvec2 pixel(random.uniform(-0.5, lens.width_px - 0.5),
                      random.uniform(-0.5, lens.height_px - 0.5));
    const auto direction = camera_from_pixel(lens, pixel);
    if (!direction) continue;
    ++answered;
    EXPECT_NEAR(glm::length(*direction), 1.0, 1e-14);
    const auto again = pixel_from_camera(lens, *direction);
    ASSERT_TRUE(again) << i;
    // 1e-9 is the contract; a pixel far beyond any field of view has fewer digits left.
    const double digits = 1.0 / std::max(direction->z, 1e-6);
    EXPECT_LT(glm::length(*again - pixel), 1e-9 * digits) << i;
  }
  EXPECT_GT(answered, 1000);  // the others lie beyond the fold of a long-sided random lens
}

TEST_P(EveryLens, InverseReturnsTheDirection) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Lens lens = random_lens(random, GetParam());
    const dvec3 point = random_point_in_camera(random);
    const auto direction = camera_from_pixel(lens, *pixel_from_camera(lens, point));
    ASSERT_TRUE(direction) << i;
    // Newton ends at 1e-10 px; near a fold a pixel's share of the angle is larger than 1 / focal
    // length.
    EXPECT_LT(glm::length(*direction - glm::normalize(point)), 1e-9) << i;
  }
}

TEST_P(EveryLens, NothingIsSeenBehindTheCamera) {
  Random random(4);
  const Lens lens = random_lens(random, GetParam());
  EXPECT_TRUE(pixel_from_camera(lens, {0.1, 0.1, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {0.1, 0.1, -1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {0.1, 0.1, 0.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {0.0, 0.0, 0.0}));
}

TEST_P(EveryLens, NumbersThatAreNoneGiveNoAnswer) {
  Random random(5);
  const Lens lens = random_lens(random, GetParam());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(pixel_from_camera(lens, {0.0, 0.0, nan}));
  EXPECT_FALSE(pixel_from_camera(lens, {nan, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {infinity, 0.0, 1.0}));
  EXPECT_FALSE(camera_from_pixel(lens, {nan, 0.0}));
  EXPECT_FALSE(camera_from_pixel(lens, {infinity, 0.0}));
}

TEST_P(EveryLens, TheAxisMeetsThePrincipalPoint) {
  Random random(6);
  const Lens lens = random_lens(random, GetParam());
  EXPECT_EQ(*pixel_from_camera(lens, {0.0, 0.0, 3.0}), lens.principal_px);
  EXPECT_EQ(*camera_from_pixel(lens, lens.principal_px), dvec3(0.0, 0.0, 1.0));
}

TEST_P(EveryLens, WorldRayPassesThroughWhatThePixelShows) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Camera camera{"a", random_lens(random, GetParam()), random_pose(random)};
    const dvec3 point = inverse(camera.camera_from_world) * random_point_in_camera(random);
    const auto pixel = project(camera, point);
    ASSERT_TRUE(pixel);
    const auto ray = world_ray(camera, *pixel);
    ASSERT_TRUE(ray);
    EXPECT_LT(glm::length(ray->origin - camera.centre_in_world()), 1e-12);
    const double distance = glm::dot(point - ray->origin, ray->direction);
    EXPECT_GT(distance, 0.0);
    EXPECT_LT(glm::length(ray->origin + distance * ray->direction - point), 1e-7);
  }
}

TEST_P(EveryLens, ScalingAnImageMovesItsCornersToItsCorners) {
  Random random(8);
  const Lens lens = random_lens(random, GetParam());
  const Lens small = scaled(lens, lens.width_px / 3, lens.height_px / 5);
  EXPECT_EQ(small.width_px, lens.width_px / 3);
  for (int i = 0; i < 100; ++i) {
    const dvec3 point = random_point_in_camera(random);
    const dvec2 size(lens.width_px, lens.height_px), small_size(small.width_px, small.height_px);
    const dvec2 share = (*pixel_from_camera(lens, point) + 0.5) / size;
    const dvec2 small_share = (*pixel_from_camera(small, point) + 0.5) / small_size;
    EXPECT_LT(glm::length(share - small_share), 1e-12);
  }
}

Lens barrel(double k1, double k2 = 0.0) {
  return {LensModel::opencv, 1000, 1000, dvec2(1000.0), dvec2(499.5), {k1, k2}};
}

TEST(Fold, PointsBeyondItAreNotSeen) {
  const Lens lens = barrel(-0.3);
  const double fold = std::sqrt(1.0 / 0.9);  // d/dr (r - 0.3 r^3) = 0
  EXPECT_TRUE(pixel_from_camera(lens, {fold - 1e-6, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {fold + 1e-6, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {0.0, -100.0, 1.0}));
}

TEST(Fold, StaysHiddenWhereTheRadiusGrowsAgain) {
  const Lens lens = barrel(-0.5, 0.08);  // falls between r = 0.99 and 1.6, then rises
  EXPECT_TRUE(pixel_from_camera(lens, {0.9, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {1.2, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {3.0, 0.0, 1.0}));
}

TEST(Fold, APoleOfTheRationalModelEndsTheImage) {
  Lens lens = barrel(0.0);
  lens.distortion[5] = -0.25;  // 1 / (1 - r^2 / 4)
  EXPECT_TRUE(pixel_from_camera(lens, {1.9, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {2.1, 0.0, 1.0}));
  EXPECT_TRUE(camera_from_pixel(lens, {1e6, 1e6}));  // every radius is reached before the pole
}

TEST(Fold, PixelsOutsideTheFoldCircleHaveNoRay) {
  const Lens lens = barrel(-0.3);
  const double largest_px = 1000.0 * std::sqrt(1.0 / 0.9) * 2.0 / 3.0;
  EXPECT_TRUE(camera_from_pixel(lens, {499.5 + largest_px - 1e-3, 499.5}));
  EXPECT_FALSE(camera_from_pixel(lens, {499.5 + largest_px + 1e-3, 499.5}));
  EXPECT_FALSE(camera_from_pixel(lens, {1e9, 0.0}));
}

TEST(Fold, OfAFisheyeIsFoundInTheAngle) {
  Lens lens = barrel(-0.2);
  lens.model = LensModel::opencv_fisheye;
  const double fold = std::sqrt(1.0 / 0.6);  // d/da (a - 0.2 a^3) = 0, 74 degrees
  EXPECT_TRUE(pixel_from_camera(lens, {std::sin(fold - 1e-6), 0.0, std::cos(fold - 1e-6)}));
  EXPECT_FALSE(pixel_from_camera(lens, {std::sin(fold + 1e-6), 0.0, std::cos(fold + 1e-6)}));
}

TEST(Fold, OfTheTangentialPartHidesPointsToo) {
  Lens lens = barrel(0.0);
  lens.distortion[3] = 0.1;  // x + 0.3 x^2 along the x axis, falling below x = -1.67
  EXPECT_TRUE(pixel_from_camera(lens, {-1.6, 0.0, 1.0}));
  EXPECT_FALSE(pixel_from_camera(lens, {-1.7, 0.0, 1.0}));
}

TEST(Fisheye, AnEquidistantLensSeesTheAngleAsTheRadius) {
  const Lens lens{LensModel::opencv_fisheye, 1000, 1000, dvec2(500.0), dvec2(499.5), {}};
  const double angle = 1.5;  // 86 degrees
  const auto pixel = pixel_from_camera(lens, {std::sin(angle), 0.0, std::cos(angle)});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 499.5 + 500.0 * angle, 1e-9);
  EXPECT_FALSE(camera_from_pixel(lens, {499.5 + 500.0 * 1.6, 499.5}));  // behind the camera
}

TEST(Lens, HalfTheSizePutsPixelCentresBetweenTwo) {
  Lens lens{LensModel::pinhole, 100, 60, dvec2(80.0), dvec2(10.5, 20.5), {}};
  const Lens half = scaled(lens, 50, 30);
  EXPECT_EQ(half.principal_px, dvec2(5.0, 10.0));  // pixels 10 and 11 become pixel 5
  EXPECT_EQ(half.focal_px, dvec2(40.0));
}

TEST(Lens, UndistortedKeepsThePinhole) {
  Random random(9);
  const Lens lens = random_lens(random, LensModel::opencv);
  const Lens straight = undistorted(lens);
  EXPECT_EQ(straight.model, LensModel::pinhole);
  EXPECT_EQ(straight.focal_px, lens.focal_px);
  EXPECT_EQ(straight.principal_px, lens.principal_px);
  EXPECT_EQ(*pixel_from_camera(straight, {1.0, 2.0, 4.0}),
            lens.principal_px + lens.focal_px * dvec2(0.25, 0.5));
}

}  // namespace
}  // namespace bosk
