#include "core/measure/matte_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace bosk {
namespace {

using Matte4 = Image<glm::dvec4>;

TEST(ScoreMatte, EqualMattesHaveNoError) {
  Matte4 matte(9, 7, {0.1, 0.2, 0.3, 0.5});
  matte(4, 4).a = 1.0;
  const MatteScore score = score_matte(matte, matte);
  for (const MatteScoreField& field : kMatteScoreFields)
    EXPECT_EQ(score.*field.value, 0.0) << field.name;
}

// Too full by 0.25 everywhere: 1000 pixels a megapixel-thousandth, so sad = 250 whatever the size.
TEST(ScoreMatte, AConstantErrorFollowsTheFormulas) {
  const Matte4 truth(30, 20, {0.5, 0.5, 0.5, 0.5}), full(30, 20, {0.5, 0.5, 0.5, 0.75});
  const MatteScore score = score_matte(full, truth);
  EXPECT_NEAR(score.sad, 250.0, 1e-9);
  EXPECT_NEAR(score.mse, 62.5, 1e-9);
  EXPECT_NEAR(score.bias, 0.25, 1e-12);
  EXPECT_NEAR(score.grad, 0.0, 1e-12);
  EXPECT_NEAR(score_matte(truth, full).bias, -0.25, 1e-12);
}

// A step of 1 along x against nothing: the gradient's profile is the Gaussian itself, whose squares
// on whole pixels add up to 1 / (2 sqrt(pi) sigma). The taps sample its slope, which overstates
// that by 1 / (24 sigma^2) = 2.1 %.
TEST(ScoreMatte, GradientErrorOfAStepIsTheGaussiansEnergy) {
  Matte4 step(60, 10, glm::dvec4(0.0));
  for (int y = 0; y < 10; ++y) {
    for (int x = 30; x < 60; ++x) step(x, y).a = 1.0;
  }
  const double energy_per_row = 1.0 / (2.0 * std::sqrt(3.14159265358979) * 1.4);
  const double expected = 10 * energy_per_row / 1000 / (600 / 1e6);
  EXPECT_NEAR(score_matte(step, Matte4(60, 10, glm::dvec4(0.0))).grad, expected, 0.03 * expected);
}

TEST(ScoreMatte, ForegroundErrorIsWeightedByTrueAlpha) {
  Matte4 truth(2, 1, {0.0, 0.0, 0.0, 1.0}), matte = truth;
  truth(1, 0).a = 0.0;
  matte(0, 0) = {0.2, 0.2, 0.2, 1.0};
  matte(1, 0) = {1.0, 1.0, 1.0, 0.0};
  EXPECT_NEAR(score_matte(matte, truth).foreground, 51.0, 1e-9);
}

TEST(ScoreMatte, RefusesOtherSizes) {
  EXPECT_THROW(score_matte(Matte4(3, 3), Matte4(3, 4)), Error);
  EXPECT_THROW(score_matte(Matte4(), Matte4()), Error);
}

}  // namespace
}  // namespace bosk
