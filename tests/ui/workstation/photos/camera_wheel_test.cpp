#include "ui/workstation/photos/camera_wheel.h"

#include <gtest/gtest.h>

#include "tests/ui/workstation/round_cameras.h"

namespace bosk {
namespace {

constexpr double kDegree = 0.017453292519943295;

CameraWheel wheel_at(const std::vector<double>& angles_deg) {
  const std::vector<Camera> cameras = cameras_at(angles_deg);
  return wheel_of(cameras, middle_of(cameras));
}

TEST(MiddleOf, IsThePointThatAllCamerasLookAt) {
  const std::vector<Camera> cameras = cameras_at({0, 70, 200});
  // Rounding alone: the axes meet in it
  EXPECT_LT(glm::distance(middle_of(cameras), glm::dvec3(1, 2, 3)), 1e-9);
}

TEST(MiddleOf, IsTheOriginWhereTheAxesDontTell) {
  EXPECT_EQ(middle_of(cameras_at({40})), glm::dvec3(0.0));
  std::vector<Camera> parallel = cameras_at({40, 40});
  parallel[1].camera_from_world.translation += glm::dvec3(1, 0, 0);
  EXPECT_EQ(middle_of(parallel), glm::dvec3(0.0));
  EXPECT_EQ(middle_of({}), glm::dvec3(0.0));
}

TEST(CameraWheel, PutsCamerasByAngleLookingInwards) {
  const CameraWheel wheel = wheel_at({200, 10, 100});
  ASSERT_EQ(wheel.spokes.size(), 3u);
  EXPECT_EQ(wheel.spokes[0].name, "10");
  EXPECT_EQ(wheel.spokes[2].name, "200");
  EXPECT_NEAR(wheel.spokes[1].angle, 100 * kDegree, 1e-9);
  EXPECT_NEAR(wheel.radius_m, 8.0, 1e-9);
  for (const WheelSpoke& spoke : wheel.spokes) {
    EXPECT_NEAR(glm::dot(spoke.looks, glm::normalize(spoke.place_m)), -1.0, 1e-9);
  }
}

TEST(CameraWheel, FindsTheWidestGapAlsoAcrossTheXAxis) {
  const CameraWheel wheel = wheel_at({20, 80, 140, 200, 260, 270});
  const auto gap = widest_gap(wheel);
  ASSERT_TRUE(gap);
  EXPECT_EQ(gap->from, "270");
  EXPECT_EQ(gap->to, "20");
  EXPECT_NEAR(gap->size, 110 * kDegree, 1e-9);
}

TEST(CameraWheel, GapsGoOnceRound) {
  double sum = 0.0;
  for (const WheelGap& gap : wheel_at({5, 30, 31, 200}).gaps) sum += gap.size;
  EXPECT_NEAR(sum, 360 * kDegree, 1e-9);
  EXPECT_NEAR(wheel_at({45}).gaps.at(0).size, 360 * kDegree, 1e-9);
}

TEST(CameraWheel, SaysItInWords) {
  EXPECT_EQ(words_of(wheel_at({0, 90, 200})),
            "3 photos; the widest gap is 160 degrees, from 200 to 0");
  EXPECT_EQ(words_of(wheel_at({0})), "1 photo, from one side only");
  EXPECT_EQ(words_of(CameraWheel()), "no photo has a camera");
}

}  // namespace
}  // namespace bosk
