#include "ui/workstation/calibrate/error_ellipse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/ui/workstation/round_cameras.h"

namespace bosk {
namespace {

// The largest distance from `middle` along x and y.
glm::dvec2 reach_of(const std::vector<glm::dvec2>& outline, const glm::dvec2& middle) {
  glm::dvec2 reach(0.0);
  for (const glm::dvec2& each : outline) reach = glm::max(reach, glm::abs(each - middle));
  return reach;
}

TEST(SeenEllipse, HasTheSizeOfItsSigmasInPixels) {
  // Looks along the world's y, so that x is across and z is up in the picture
  const Camera eye = camera_looking("eye", {0, -10, 0}, {0, 0, 0});
  glm::dmat3 covariance(0.0);
  covariance[0][0] = 0.01 * 0.01;
  covariance[1][1] = 1.0;  // along the line of sight: not to be seen
  covariance[2][2] = 0.02 * 0.02;
  const auto outline = seen_ellipse(eye, {0, 0, 0}, covariance, 3.0);
  ASSERT_TRUE(outline);
  const glm::dvec2 reach = reach_of(*outline, eye.lens.principal_px);
  const double px_a_metre = 500.0 / 10.0;
  EXPECT_NEAR(reach.x, 3.0 * 0.01 * px_a_metre, 1e-9);
  EXPECT_NEAR(reach.y, 3.0 * 0.02 * px_a_metre, 1e-9);
}

TEST(SeenEllipse, IsTheSameWhereverTheAxesOfTheWorldPoint) {
  const Camera eye = camera_looking("eye", {0, -10, 0}, {0, 0, 0});
  // A needle of 0.1 m that leans by 45 degrees in the picture's plane
  const glm::dvec3 needle = 0.1 * glm::dvec3(std::numbers::sqrt2 / 2, 0, std::numbers::sqrt2 / 2);
  const auto outline = seen_ellipse(eye, {0, 0, 0}, glm::outerProduct(needle, needle), 1.0);
  ASSERT_TRUE(outline);
  for (const glm::dvec2& each : *outline) {
    const glm::dvec2 from_middle = each - eye.lens.principal_px;
    EXPECT_NEAR(from_middle.x, -from_middle.y, 1e-6) << "up in the world is up in the picture";
  }
  EXPECT_NEAR(reach_of(*outline, eye.lens.principal_px).x, 500.0 / 10.0 * needle.x, 1e-6);
}

TEST(SeenEllipse, IsNoneBehindTheCamera) {
  const Camera eye = camera_looking("eye", {0, -10, 0}, {0, 0, 0});
  EXPECT_FALSE(seen_ellipse(eye, {0, -11, 0}, glm::dmat3(1e-4), 1.0));
}

TEST(Exaggeration, MakesTheMedianErrorBarAboutAsLargeAsWantedInRoundNumbers) {
  const auto bar = [](double sigma) { return glm::dmat3(sigma * sigma / 3.0); };
  const std::vector<glm::dmat3> bars = {bar(0.001), bar(0.01), bar(5.0), glm::dmat3(0.0)};
  EXPECT_EQ(exaggeration_for(bars, 0.3), 20.0);
  EXPECT_EQ(exaggeration_for(bars, 0.001), 1.0) << "never smaller than they are";
  EXPECT_EQ(exaggeration_for({}, 0.3), 1.0);
}

}  // namespace
}  // namespace bosk
