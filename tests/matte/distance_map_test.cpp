#include "core/matte/distance_map.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bosk {
namespace {

TEST(SquaredDistanceTo, AgreesWithBruteForce) {
  Image<std::uint8_t> marked(23, 17);
  marked(3, 4) = marked(20, 1) = marked(11, 16) = marked(12, 9) = 1;
  const Image<float> squared = squared_distance_to(marked);
  for (int y = 0; y < marked.height(); ++y) {
    for (int x = 0; x < marked.width(); ++x) {
      int least = 1 << 30;
      for (int v = 0; v < marked.height(); ++v) {
        for (int u = 0; u < marked.width(); ++u) {
          if (marked(u, v)) least = std::min(least, (u - x) * (u - x) + (v - y) * (v - y));
        }
      }
      ASSERT_EQ(squared(x, y), float(least)) << x << ", " << y;  // whole numbers are exact
    }
  }
}

TEST(SquaredDistanceTo, IsVeryFarWhenNothingIsMarked) {
  const Image<float> squared = squared_distance_to(Image<std::uint8_t>(5, 4));
  EXPECT_GT(*std::min_element(squared.pixels().begin(), squared.pixels().end()), 1e9f);
}

TEST(SquaredDistanceTo, TakesOnePixel) {
  EXPECT_EQ(squared_distance_to(Image<std::uint8_t>(1, 1, 1))(0, 0), 0.0f);
}

}  // namespace
}  // namespace bosk
