#include "core/matte/foreground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "leafy_scene.h"

namespace bosk {
namespace {

TEST(EstimateForeground, FreesColoursFromTheBackground) {
  const Image<glm::vec3> leaf(64, 48, glm::vec3(0.05f, 0.2f, 0.02f));
  Image<float> alpha(64, 48);
  Image<glm::vec3> light(64, 48);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      alpha(x, y) =
          std::clamp((20.0f - std::hypot(float(x - 32), float(y - 24))) / 8.0f, 0.0f, 1.0f);
      light(x, y) = glm::mix(glm::vec3(0.7f, 0.8f, 1.0f), leaf(x, y), alpha(x, y));
    }
  }
  Progress progress;
  const Image<glm::vec3> front = estimate_foreground(light, alpha, progress);
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (alpha.data()[i] < 0.3f) continue;
    // Both layers are flat, so only the pull between neighbours, 1e-5, keeps it from being exact
    EXPECT_LT(glm::distance(front.data()[i], leaf.data()[i]), 0.01f) << "alpha " << alpha.data()[i];
  }
}

TEST(EstimateForeground, BeatsThePhotoOnLeaves) {
  const LeafyScene scene = leafy_scene();
  Image<glm::vec3> light(scene.alpha.width(), scene.alpha.height());
  for (std::size_t i = 0; i < light.size(); ++i) {
    light.data()[i] =
        glm::mix(glm::vec3(0.5f, 0.7f, 1.0f), scene.front_linear.data()[i], scene.alpha.data()[i]);
  }
  Progress progress;
  const Image<glm::vec3> front = estimate_foreground(light, scene.alpha, progress);
  double photo_error = 0.0, error = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (scene.alpha.data()[i] < 0.1f || scene.alpha.data()[i] > 0.9f) continue;
    photo_error += glm::distance(light.data()[i], scene.front_linear.data()[i]);
    error += glm::distance(front.data()[i], scene.front_linear.data()[i]);
  }
  EXPECT_LT(
      error,
      0.25 * photo_error);  // published: a third of the photo's colour difference; light is kinder
}

TEST(EstimateForeground, KeepsOpaquePixels) {
  const LeafyScene scene = leafy_scene();
  Progress progress;
  const Image<glm::vec3> front =
      estimate_foreground(scene.front_linear, Image<float>(180, 140, 1.0f), progress);
  for (std::size_t i = 0; i < front.size(); ++i) {
    ASSERT_LT(glm::distance(front.data()[i], scene.front_linear.data()[i]), 1e-4f);
  }
}

TEST(EstimateForeground, IsFiniteAndInRangeWhereAllIsClear) {
  Progress progress;
  const auto front =
      estimate_foreground(Image<glm::vec3>(33, 7, glm::vec3(1.0f)), Image<float>(33, 7), progress);
  for (const glm::vec3& colour : front.pixels()) {
    for (int c = 0; c < 3; ++c) ASSERT_TRUE(colour[c] >= 0.0f && colour[c] <= 1.0f);
  }
}

TEST(EstimateForeground, TakesOnePixel) {
  Progress progress;
  const auto front = estimate_foreground(Image<glm::vec3>(1, 1, glm::vec3(0.5f)),
                                         Image<float>(1, 1, 1.0f), progress);
  EXPECT_NEAR(front(0, 0).x, 0.5f, 1e-4f);
}

}  // namespace
}  // namespace bosk
