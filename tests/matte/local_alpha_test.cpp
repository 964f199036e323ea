#include "core/matte/local_alpha.h"

#include <gtest/gtest.h>

#include "leafy_scene.h"

namespace bosk {
namespace {

TEST(RefineLocally, MendsHalfCoveredPixelsFromColoursCloseBy) {
  // A soft edge between two flat colours, its alpha 0.15 too high in between. It is 10 px wide;
  // colours are sought 1 % of the diagonal (5 px) away, as a standard deviation
  Image<glm::vec3> linear(400, 300);
  Image<float> truth(400, 300), alpha(400, 300);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      truth(x, y) = std::clamp((float(x) - 195.0f) / 10.0f, 0.0f, 1.0f);
      linear(x, y) =
          glm::mix(glm::vec3(0.5f, 0.7f, 0.9f), glm::vec3(0.03f, 0.1f, 0.02f), truth(x, y));
      const bool half = truth(x, y) > 0.0f && truth(x, y) < 1.0f;
      alpha(x, y) = half ? std::min(truth(x, y) + 0.15f, 0.94f) : truth(x, y);
    }
  }
  const double before = mean_absolute_error(alpha, truth);
  Progress progress;
  refine_locally(linear, 5.0f, alpha, progress);
  EXPECT_LT(mean_absolute_error(alpha, truth),
            0.1 * before);  // both colours are flat: only rounding is left
}

TEST(RefineLocally, LeavesPixelsWithoutSureOnesCloseBy) {
  Image<float> alpha(40, 30, 0.4f);
  Progress progress;
  refine_locally(Image<glm::vec3>(40, 30, glm::vec3(0.3f)), 5.0f, alpha, progress);
  EXPECT_EQ(alpha, Image<float>(40, 30, 0.4f));
}

}  // namespace
}  // namespace bosk
