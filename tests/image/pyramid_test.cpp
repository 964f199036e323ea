#include "core/image/pyramid.h"

#include <gtest/gtest.h>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr float kRounding = 1e-5f;  // a few roundings of single precision through the sRGB curve

TEST(HalfSize, KeepsPixelCentres) {
  // A ramp's value is its place: the mean of a 2 x 2 block must be the place of the block's centre
  Image<float> ramp(8, 6);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) ramp(x, y) = float(x + 10 * y);
  }
  const Image<float> half = half_size(ramp);
  ASSERT_EQ(half.width(), 4);
  ASSERT_EQ(half.height(), 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) {
      const glm::dvec2 place = pixel_from_half_size_pixel({x, y});
      EXPECT_FLOAT_EQ(half(x, y), float(place.x + 10 * place.y));
      EXPECT_EQ(half_size_pixel_from_pixel(place), glm::dvec2(x, y));
    }
  }
}

TEST(HalfSize, AveragesWhatIsThereAtAnOddEdge) {
  Image<float> image(3, 1);
  image(0, 0) = 1.0f;
  image(1, 0) = 3.0f;
  image(2, 0) = 7.0f;
  const Image<float> half = half_size(image);
  ASSERT_EQ(half.width(), 2);
  ASSERT_EQ(half.height(), 1);
  EXPECT_EQ(half(0, 0), 2.0f);
  EXPECT_EQ(half(1, 0), 7.0f);
}

TEST(HalfSize, AveragesLightNotCode) {
  Image<glm::vec3> checker(2, 2, glm::vec3(0.0f));
  checker(0, 0) = checker(1, 1) = glm::vec3(1.0f);
  EXPECT_NEAR(half_size_srgb(checker)(0, 0).g, srgb_from_linear(0.5f), kRounding);
}

TEST(HalfSize, LetsNoColourBleedFromClearPixels) {
  const glm::vec4 leaf(0.2f, 0.6f, 0.1f, 1.0f), clear(1.0f, 0.0f, 1.0f, 0.0f);
  Image<glm::vec4> edge(2, 2, clear);
  edge(0, 0) = leaf;
  const glm::vec4 mean = half_size_straight(edge)(0, 0);
  EXPECT_NEAR(mean.a, 0.25f, kRounding);
  // Clear pixels count with a trace of 1e-6: after the sRGB curve's slope of 13 at black, 1e-4
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], leaf[c], 1e-4f);
}

TEST(HalfSize, KeepsColourWhereAllIsClear) {
  const Image<glm::vec4> clear(2, 2, glm::vec4(0.3f, 0.4f, 0.5f, 0.0f));
  const glm::vec4 mean = half_size_straight(clear)(0, 0);
  EXPECT_EQ(mean.a, 0.0f);
  EXPECT_NEAR(mean.g, 0.4f, kRounding);
}

TEST(Pyramid, EndsAtTheSmallestSize) {
  const auto levels = pyramid_srgb(Image<glm::vec3>(100, 37, glm::vec3(0.5f)), 10);
  ASSERT_EQ(levels.size(), 5u);
  EXPECT_EQ(levels.back().width(), 7);
  EXPECT_NEAR(levels.back()(3, 1).r, 0.5f, kRounding);
}

}  // namespace
}  // namespace bosk
