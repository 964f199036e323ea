#include "core/render/splat.h"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <random>

#include "tests/render/slow_splat.h"

namespace bosk {
namespace {

std::vector<Float4> random_texture(int texels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<Float4> texture(std::size_t(texels * texels));
  for (Float4& texel : texture) {
    texel = Float4{unit(random), unit(random), unit(random), 1.0f};
    texel *= unit(random);
  }
  return texture;
}

// A square of `side_px`, turned and then sheared a little, as a lens does.
Splat turned_square(glm::vec2 centre, float side_px, double turn, float shear = 0.0f) {
  Splat splat;
  splat.centre_px = centre;
  splat.across_px = 0.5f * side_px * glm::vec2(std::cos(turn), std::sin(turn));
  splat.down_px =
      0.5f * side_px * glm::vec2(-std::sin(turn), std::cos(turn)) + shear * splat.across_px;
  return splat;
}

// A picture of 3 x 3 tiles with the splat drawn over it.
Image<glm::vec4> drawn(const Splat& splat, const std::vector<Float4>& texture, int texels) {
  Image<glm::vec4> image(3 * kTile_px, 3 * kTile_px);
  const auto tile = std::make_unique<Tile>();
  for (int t = 0; t < 9; ++t) {
    *tile = Tile{};
    tile->left_px = (t % 3) * kTile_px;
    tile->top_px = (t / 3) * kTile_px;
    tile->width_px = tile->height_px = kTile_px;
    composite_splat(splat, texture.data(), texels, 1.0f, *tile);
    for (int y = 0; y < kTile_px; ++y)
      for (int x = 0; x < kTile_px; ++x) {
        const Float4 p = tile->pixels[y * kTile_px + x];
        image(tile->left_px + x, tile->top_px + y) = {p[0], p[1], p[2], p[3]};
      }
  }
  return image;
}

glm::dvec4 sum_of(const Image<glm::vec4>& image) {
  glm::dvec4 sum(0.0);
  for (const glm::vec4& pixel : image.pixels()) sum += glm::dvec4(pixel);
  return sum;
}

double rms_difference(const Image<glm::vec4>& a, const Image<glm::vec4>& b, double area_px) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec4 d(a.pixels()[i] - b.pixels()[i]);
    sum += glm::dot(d, d) / 4.0;
  }
  return std::sqrt(sum / std::max(area_px, 1.0));
}

class SplatOfTexels : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(FourAndEight, SplatOfTexels, testing::Values(4, 8));

// Interpolation held at the border has the plain mean of the texels as its mean.
TEST_P(SplatOfTexels, AddsTheSameOpacityAtEverySizePlaceAndTurn) {
  const int texels = GetParam();
  const std::vector<Float4> texture = random_texture(texels, 1);
  Float4 mean{};
  for (const Float4& texel : texture) mean += texel / float(texels * texels);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> place(47.0f, 48.0f), angle(0.0f, 6.2831f);
  for (const float side_px : {0.3f, 0.7f, 1.0f, 1.9f, 3.3f, 5.0f, 9.1f, 17.0f, 40.0f})
    for (int trial = 0; trial < 20; ++trial) {
      const double turn = trial < 5 ? 0.0 : angle(random);
      const Splat splat =
          turned_square({place(random), place(random)}, side_px, turn, 0.05f * float(trial % 3));
      const glm::dvec4 sum = sum_of(drawn(splat, texture, texels));
      for (int channel = 0; channel < 4; ++channel) {
        const double expected = side_px * side_px * double(mean[channel]);
        // float rounding of positions near 50 px is 4e-6 px, felt on an edge of 0.3 px and more
        ASSERT_NEAR(sum[channel], expected, 2e-4 * expected) << side_px << " px, " << turn;
      }
    }
}

TEST_P(SplatOfTexels, MatchesASupersampledSquareAlongTheAxes) {
  const int texels = GetParam();
  const std::vector<Float4> texture = random_texture(texels, 3);
  for (const float side_px : {0.4f, 1.5f, 4.7f, 12.3f, 50.0f})
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Splat splat =
          turned_square({40.37f, 50.81f}, side_px, quarter * 0.5 * std::numbers::pi);
      Image<glm::vec4> slow(96, 96, glm::vec4(0.0f));
      toy::slow_splat(splat, texture, texels, 32, slow);
      // 32 samples a pixel place an edge to 1/64 px; the texels differ by up to 1
      EXPECT_LT(rms_difference(drawn(splat, texture, texels), slow, side_px * side_px), 0.008)
          << side_px << " px, quarter turn " << quarter;
    }
}

TEST_P(SplatOfTexels, MatchesASupersampledSquareTurnedOrSheared) {
  const int texels = GetParam();
  const std::vector<Float4> texture = random_texture(texels, 4);
  for (const float side_px : {0.7f, 3.0f, 5.5f, 14.0f, 50.0f})
    for (const double turn : {0.03, -0.1, 0.4, 0.785, 1.5, 2.0, 3.4, 4.0, 5.5}) {
      const Splat splat = turned_square({40.37f, 50.81f}, side_px, turn, 0.07f);
      Image<glm::vec4> slow(96, 96, glm::vec4(0.0f));
      toy::slow_splat(splat, texture, texels, 8, slow);
      const double rms = rms_difference(drawn(splat, texture, texels), slow, side_px * side_px);
      RecordProperty("side_" + std::to_string(side_px) + "_turn_" + std::to_string(turn),
                     std::to_string(rms));
      // Two passes filter a turned pixel as a sheared one; largest near 45 degrees
      EXPECT_LT(rms, 0.02 + 0.07 * std::abs(std::sin(2.0 * turn)))
          << side_px << " px, turn " << turn;
    }
}

TEST(Splat, IgnoresASquareWithoutAreaOrWithoutNumbers) {
  const std::vector<Float4> texture = random_texture(4, 5);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec2 across : {glm::vec2(0.0f), glm::vec2(nan, 0.0f)})
    EXPECT_EQ(sum_of(drawn({{48, 48}, across, {0, 0}, 0}, texture, 4)), glm::dvec4(0.0));
}

TEST(Splat, StaysInsideTheTileWhenItIsHuge) {
  const std::vector<Float4> texture(16, Float4{1, 1, 1, 1});
  for (const float side_px : {1e3f, 1e5f}) {
    const Image<glm::vec4> image = drawn(turned_square({48, 48}, side_px, 0.3), texture, 4);
    for (const glm::vec4& pixel : image.pixels()) ASSERT_NEAR(pixel.a, 1.0f, 0.01f) << side_px;
  }
}

}  // namespace
}  // namespace bosk
