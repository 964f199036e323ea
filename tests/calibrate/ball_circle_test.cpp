#include "core/calibrate/ball_circle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bosk {
namespace {

const glm::dvec2 kCentre(20.3, 11.7);
constexpr double kRadius = 6.4;

// Points round a circle; those of which `hidden` says so lie half way in.
template <class Hidden>
std::vector<glm::dvec2> edge(Hidden&& hidden) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 40.0;
    const double radius = hidden(i) ? 0.5 * kRadius : kRadius;
    points.push_back(kCentre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

TEST(FitCircle, FindsAWholeCircle) {
  const auto fit = fit_circle(edge([](int) { return false; }), 3.0, 10.0, 0.4);
  ASSERT_TRUE(fit);
  EXPECT_LT(glm::distance(fit->centre, kCentre), 1e-9);
  EXPECT_NEAR(fit->radius, kRadius, 1e-9);
  EXPECT_EQ(fit->inliers, 40);
}

TEST(FitCircle, KeepsTheCentreWhenHalfTheEdgeIsHidden) {
  const auto fit = fit_circle(edge([](int i) { return i < 20; }), 3.0, 10.0, 0.4);
  ASSERT_TRUE(fit);
  EXPECT_LT(glm::distance(fit->centre, kCentre), 1e-6);
  EXPECT_EQ(fit->inliers, 20);
  EXPECT_FALSE(fit->belongs[5]);
}

TEST(FitCircle, IsLessCertainOfAShortArc) {
  const auto whole = fit_circle(edge([](int) { return false; }), 3.0, 10.0, 0.4);
  const auto arc = fit_circle(edge([](int i) { return i < 24; }), 3.0, 10.0, 0.4);
  ASSERT_TRUE(whole && arc);
  EXPECT_GT(arc->centre_sigma, 2.0 * whole->centre_sigma);
}

TEST(FitCircle, GivesNothingOutsideTheRadiiAskedFor) {
  EXPECT_FALSE(fit_circle(edge([](int) { return false; }), 7.0, 10.0, 0.2));
  EXPECT_FALSE(fit_circle(std::vector<glm::dvec2>(4, kCentre), 1.0, 10.0, 0.4));
}

}  // namespace
}  // namespace bosk
