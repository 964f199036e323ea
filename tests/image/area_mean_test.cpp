#include "core/image/area_mean.h"

#include <gtest/gtest.h>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr float kRounding = 1e-5f;  // a few roundings of single precision

TEST(AreaMean, KeepsTheMeanAtAnyRatio) {
  Image<float> image(10, 7);
  float sum = 0.0f;
  for (std::size_t i = 0; i < image.size(); ++i) sum += image.data()[i] = float(i * i % 13);
  for (const glm::ivec2 size : {glm::ivec2(10, 7), glm::ivec2(3, 2), glm::ivec2(1, 1)}) {
    const Image<float> small = area_mean(image, size.x, size.y);
    float small_sum = 0.0f;
    for (const float value : small.pixels()) small_sum += value;
    EXPECT_NEAR(small_sum / float(small.size()), sum / float(image.size()), 10 * kRounding);
  }
}

TEST(AreaMean, SharesAPixelBetweenItsNeighbours) {
  Image<float> image(3, 1);
  image(1, 0) = 3.0f;
  const Image<float> small = area_mean(image, 2, 1);
  EXPECT_NEAR(small(0, 0), 1.0f, kRounding);  // half of the 3, over 1.5 pixels
  EXPECT_NEAR(small(1, 0), 1.0f, kRounding);
}

TEST(AreaMean, IsTheImageAtItsOwnSize) {
  Image<glm::vec3> image(4, 3);
  for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] = glm::vec3(float(i), 1.0f, 2.0f);
  EXPECT_EQ(area_mean(image, 4, 3), image);
}

TEST(AreaMeanSrgb, AveragesLight) {
  Image<glm::vec3> image(2, 1);
  image(1, 0) = glm::vec3(1.0f);
  EXPECT_NEAR(area_mean_srgb(image, 1, 1)(0, 0).g, srgb_from_linear(0.5f), kRounding);
}

TEST(AreaMeanStraight, CountsColoursByTheirAlpha) {
  Image<glm::vec4> image(2, 1);
  image(0, 0) = glm::vec4(0.6f, 0.4f, 0.2f, 0.5f);
  image(1, 0) = glm::vec4(1.0f, 1.0f, 1.0f, 0.0f);
  const glm::vec4 mean = area_mean_straight(image, 1, 1)(0, 0);
  EXPECT_NEAR(mean.r, 0.6f, kRounding);
  EXPECT_NEAR(mean.a, 0.25f, kRounding);
}

}  // namespace
}  // namespace bosk
