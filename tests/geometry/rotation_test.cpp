#include "core/geometry/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/geometry/rigid_transform.h"

namespace bosk {
namespace {

using glm::dmat3;
using glm::dvec3;

constexpr double kRounding = 1e-14;  // some fifty roundings of numbers up to 1

double largest_difference(const dmat3& a, const dmat3& b) {
  double largest = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
  return largest;
}

dvec3 random_unit(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

TEST(Rodrigues, QuarterTurnAboutZTakesXToY) {
  const dmat3 turn = rotation_from_rodrigues({0.0, 0.0, std::numbers::pi / 2});
  EXPECT_LT(glm::length(turn * dvec3(1, 0, 0) - dvec3(0, 1, 0)), kRounding);
}

TEST(Rodrigues, ReturnsTheVectorForEveryAngleUpToPi) {
  std::mt19937_64 random(1);
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-7, 1e-3, 1.0, 3.0, 3.1415926, 3.14159265358}) {
    for (int i = 0; i < 50; ++i) {
      const dvec3 vector = angle * random_unit(random);
      EXPECT_LT(glm::length(rodrigues_from_rotation(rotation_from_rodrigues(vector)) - vector),
                1e-13)
          << angle;
    }
  }
}

TEST(Rodrigues, GivesAtMostPi) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100; ++i) {
    const dmat3 rotation = rotation_from_rodrigues(0.1 * i * random_unit(random));
    const dvec3 vector = rodrigues_from_rotation(rotation);
    EXPECT_LE(glm::length(vector), std::numbers::pi + kRounding);
    EXPECT_LT(largest_difference(rotation_from_rodrigues(vector), rotation), kRounding);
  }
}

TEST(NearestRotation, UndoesRoundingToSixDecimals) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    const dmat3 truth = rotation_from_rodrigues(2.0 * random_unit(random));
    dmat3 rounded = truth;
    for (int c = 0; c < 3; ++c) rounded[c] = glm::round(rounded[c] * 1e6) / 1e6;
    const dmat3 nearest = nearest_rotation(rounded);
    EXPECT_LT(rotation_error(nearest), kRounding);
    EXPECT_LT(largest_difference(nearest, truth), 2e-6);  // rounding moves entries by 5e-7 each
  }
}

TEST(RotationError, SeesScaleShearAndMirror) {
  EXPECT_EQ(rotation_error(dmat3(1.0)), 0.0);
  EXPECT_NEAR(rotation_error(dmat3(1.1)), 0.21, kRounding);
  EXPECT_GE(rotation_error(dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1)), 1.0);
  EXPECT_NEAR(rotation_error(dmat3(1, 0, 0, 0.1, 1, 0, 0, 0, 1)), 0.1, kRounding);
}

TEST(FitRotation, IsBluntForPointsOnALine) {
  const dvec3 a(1.0, 2.0, 3.0);
  EXPECT_LT(fit_rotation(glm::outerProduct(a, a)).sharpness, 1e-12);
  EXPECT_GT(fit_rotation(dmat3(1.0)).sharpness, 0.1);
}

TEST(RigidTransform, InverseComposesToIdentity) {
  std::mt19937_64 random(4);
  const RigidTransform a_from_b{rotation_from_rodrigues(random_unit(random)), {1.0, -2.0, 3.0}};
  const RigidTransform same = a_from_b * inverse(a_from_b);
  EXPECT_LT(largest_difference(same.rotation, dmat3(1.0)), kRounding);
  EXPECT_LT(glm::length(same.translation), kRounding);
}

}  // namespace
}  // namespace bosk
