#include "core/matte/exposure.h"

#include <gtest/gtest.h>

#include "leafy_scene.h"

namespace bosk {
namespace {

TEST(ExposureGain, UndoesExposureAndWhiteBalance) {
  const glm::vec3 applied(0.85f, 0.8f, 0.72f);
  const LeafyScene normal = leafy_scene(), other = leafy_scene({.gain = applied, .leaf_seed = 2});
  const glm::vec3 gain = exposure_gain(other.photo.srgb, normal.photo.srgb);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(gain[c] * applied[c], 1.0f, 0.1f);  // other leaves: quantiles wander
}

TEST(ExposureGain, LeavesAPhotoThatIsTheSame) {
  const LeafyScene scene = leafy_scene();
  EXPECT_EQ(exposure_gain(scene.photo.srgb, scene.photo.srgb), glm::vec3(1.0f));
}

TEST(ExposureGain, IsFiniteForBlackPhotos) {
  const Image<glm::vec3> black(4, 4), white(4, 4, glm::vec3(1.0f));
  const glm::vec3 gain = exposure_gain(black, white);
  for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(gain[c]));
  EXPECT_EQ(exposure_gain({}, white), glm::vec3(1.0f));
}

}  // namespace
}  // namespace bosk
