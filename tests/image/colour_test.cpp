#include "core/image/colour.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bosk {
namespace {

TEST(Colour, SrgbCurveMeetsItsDefinition) {
  // IEC 61966-2-1: the two pieces and a value worked by hand, ((0.5 + 0.055) / 1.055)^2.4
  EXPECT_FLOAT_EQ(linear_from_srgb(0.04045f), 0.04045f / 12.92f);
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.2140411, 1e-6);
  EXPECT_FLOAT_EQ(linear_from_srgb(1.0f), 1.0f);
}

TEST(Colour, SrgbGoesThereAndBack) {
  for (int i = -50; i <= 150; ++i) {
    const float value = float(i) / 100.0f;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(value)), value, 2e-6f);
  }
}

TEST(Colour, LabOfWhiteAndOfThePrimaries) {
  const glm::vec3 white = lab_from_srgb(glm::vec3(1.0f));
  EXPECT_NEAR(white.x, 100.0f, 1e-3f);
  EXPECT_NEAR(white.y, 0.0f, 1e-3f);
  EXPECT_NEAR(white.z, 0.0f, 1e-3f);
  // Known values of sRGB red in CIELab under D65, to their two published decimals
  const glm::vec3 red = lab_from_srgb(glm::vec3(1.0f, 0.0f, 0.0f));
  EXPECT_NEAR(red.x, 53.24f, 0.02f);
  EXPECT_NEAR(red.y, 80.09f, 0.02f);
  EXPECT_NEAR(red.z, 67.20f, 0.02f);
}

TEST(Colour, LabGoesThereAndBack) {
  for (int i = 0; i < 125; ++i) {
    const glm::ivec3 step(i % 5, i / 5 % 5, i / 25);
    const glm::vec3 srgb = glm::vec3(step) / 4.0f;
    const glm::vec3 back = srgb_from_lab(lab_from_srgb(srgb));
    // 1e-6 in linear light, times the sRGB curve's slope of 12.92 at black
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], srgb[c], 2e-5f);
  }
}

}  // namespace
}  // namespace bosk
