#include "core/measure/image_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/measure/colour_difference.h"
#include "core/measure/score_table.h"

namespace bosk {
namespace {

using Picture = Image<glm::u8vec4>;

Picture noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Picture picture(width, height);
  for (auto& pixel : picture.pixels()) {
    for (int c = 0; c < 4; ++c) pixel[c] = std::uint8_t(random.below(256));
  }
  return picture;
}

TEST(ScoreView, EqualPicturesScoreBest) {
  const Picture picture = noise(40, 30, 1);
  const ViewScore score = score_view(picture, picture);
  EXPECT_EQ(score.psnr, 99.0);
  EXPECT_EQ(score.crop_psnr, 99.0);
  EXPECT_NEAR(score.ssim, 1.0, 1e-12);
  EXPECT_NEAR(score.crop_ssim, 1.0, 1e-12);
  EXPECT_EQ(score.alpha_mae, 0.0);
  EXPECT_EQ(score.edge_ratio, 1.0);
  EXPECT_EQ(score.colour_error, 0.0);
}

// Flat grey against flat grey: no variance, so SSIM is its luminance term.
TEST(ScoreView, FlatGreysFollowTheFormulas) {
  const ViewScore score =
      score_view(Picture(32, 32, {51, 51, 51, 255}), Picture(32, 32, {102, 102, 102, 255}));
  EXPECT_NEAR(score.psnr, -20.0 * std::log10(0.2), 1e-9);
  EXPECT_NEAR(score.crop_psnr, score.psnr, 1e-9);
  EXPECT_NEAR(score.ssim, (2 * 0.2 * 0.4 + 1e-4) / (0.2 * 0.2 + 0.4 * 0.4 + 1e-4), 1e-9);
  EXPECT_EQ(score.edge_ratio, 1.0);
}

// One opaque pixel at (20, 10): the crop reaches 8 px around it, 17 x 17.
TEST(ScoreView, CropIsTheBoxOfAlphaGrownByEight) {
  Picture truth(60, 50, glm::u8vec4(0));
  truth(20, 10) = {0, 0, 0, 255};
  const ViewScore score = score_view(Picture(60, 50, glm::u8vec4(0)), truth);
  EXPECT_NEAR(score.psnr, -10.0 * std::log10(1.0 / (60 * 50)), 1e-9);
  EXPECT_NEAR(score.crop_psnr, -10.0 * std::log10(1.0 / (17 * 17)), 1e-9);
  EXPECT_NEAR(score.alpha_mae, 1.0 / (17 * 17), 1e-12);
  EXPECT_EQ(score.edge_ratio, 0.0);
}

TEST(ScoreView, CropIsClippedAtTheBorder) {
  Picture truth(12, 10, glm::u8vec4(0));
  truth(0, 0).a = 255;
  EXPECT_NEAR(score_view(Picture(12, 10, glm::u8vec4(0)), truth).alpha_mae, 1.0 / (9 * 9), 1e-12);
}

// A ramp of half the slope has half the gradient everywhere, mirrored borders included.
TEST(ScoreView, EdgeRatioOfARampIsTheRatioOfSlopes) {
  Picture steep(40, 20, {0, 0, 0, 255}), flat = steep;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      steep(x, y) = glm::u8vec4(glm::u8vec3(std::uint8_t(6 * x)), 255);
      flat(x, y) = glm::u8vec4(glm::u8vec3(std::uint8_t(3 * x)), 255);
    }
  }
  EXPECT_NEAR(score_view(flat, steep).edge_ratio, 0.5, 1e-12);
  EXPECT_NEAR(score_view(steep, flat).edge_ratio, 2.0, 1e-12);
}

TEST(ScoreView, RefusesOtherSizesAndEmptyTruth) {
  EXPECT_THROW(score_view(noise(8, 8, 1), noise(8, 9, 1)), Error);
  EXPECT_THROW(score_view(noise(8, 8, 1), Picture(8, 8, {9, 9, 9, 0})), Error);
}

TEST(OverWhite, BlendsEncodedValues) {
  const Image<glm::dvec3> composite = over_white(Picture(1, 1, {255, 0, 51, 102}));
  EXPECT_NEAR(composite(0, 0).r, 1.0, 1e-15);
  EXPECT_NEAR(composite(0, 0).g, 0.6, 1e-15);
  EXPECT_NEAR(composite(0, 0).b, 0.2 * 0.4 + 0.6, 1e-15);
}

int mirrored(int i, int count) {
  if (i < 0) i = -i;
  return i >= count ? 2 * (count - 1) - i : i;
}

// The definition, pixel by pixel, against the filtered images of the implementation.
TEST(SsimMap, AgreesWithTheSumOverTheWindow) {
  const Image<glm::dvec3> a = over_white(noise(17, 13, 2)), b = over_white(noise(17, 13, 3));
  const Image<glm::dvec3> map = ssim_map(a, b);
  std::vector<double> window;
  double sum = 0.0;
  for (int i = -5; i <= 5; ++i) window.push_back(std::exp(-i * i / (2 * 1.5 * 1.5)));
  for (const double weight : window) sum += weight;
  for (const glm::ivec2 at :
       {glm::ivec2(0, 0), glm::ivec2(8, 6), glm::ivec2(16, 12), glm::ivec2(2, 11)}) {
    double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
    for (int row = 0; row <= 10; ++row) {
      for (int column = 0; column <= 10; ++column) {
        const double w = window[std::size_t(column)] * window[std::size_t(row)] / (sum * sum);
        const int x = mirrored(at.x + column - 5, 17), y = mirrored(at.y + row - 5, 13);
        const double p = a(x, y).g, q = b(x, y).g;
        ma += w * p, mb += w * q, aa += w * p * p, bb += w * q * q, ab += w * p * q;
      }
    }
    const double expected = (2 * ma * mb + 1e-4) * (2 * (ab - ma * mb) + 9e-4) /
                            ((ma * ma + mb * mb + 1e-4) * (aa - ma * ma + bb - mb * mb + 9e-4));
    EXPECT_NEAR(map(at.x, at.y).g, expected, 1e-12);
  }
}

// From the table of test pairs of Sharma, Wu and Dalal 2005, published to four decimals: the blue
// region, opposite hues, one grey, near hues, and a large difference.
TEST(ColourDifference, AgreesWithPublishedPairs) {
  const auto difference = [](double l1, double a1, double b1, double l2, double a2, double b2) {
    return colour_difference_2000({l1, a1, b1}, {l2, a2, b2});
  };
  EXPECT_NEAR(difference(50, 2.6772, -79.7751, 50, 0, -82.7485), 2.0425, 5e-5);
  EXPECT_NEAR(difference(50, -1, 2, 50, 0, 0), 2.3669, 5e-5);
  EXPECT_NEAR(difference(50, 2.49, -0.001, 50, -2.49, 0.0009), 7.1792, 5e-5);
  EXPECT_NEAR(difference(50, 2.49, -0.001, 50, -2.49, 0.0011), 7.2195, 5e-5);
  EXPECT_NEAR(difference(50, 2.5, 0, 73, 25, -18), 27.1492, 5e-5);
  EXPECT_NEAR(difference(60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387), 1.2644, 5e-5);
  EXPECT_NEAR(difference(2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514), 0.9082, 5e-5);
}

TEST(ColourDifference, IsSymmetricAndZeroForEqualColours) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const auto colour = [&] {
      return glm::dvec3(random.uniform(0, 100), random.uniform(-90, 90), random.uniform(-90, 90));
    };
    const glm::dvec3 a = colour(), b = colour();
    EXPECT_NEAR(colour_difference_2000(a, b), colour_difference_2000(b, a), 1e-9);
    EXPECT_EQ(colour_difference_2000(a, a), 0.0);
  }
}

ViewScore score_of(double value) {
  ViewScore score;
  for (const ScoreField& field : kScoreFields) score.*field.value = value;
  return score;
}

TEST(ScoreTable, MeanAndWorstAreTakenMeasureByMeasure) {
  const ScoreTable table = tabulate({{"a.png", score_of(1.0)}, {"b.png", score_of(3.0)}});
  for (const ScoreField& field : kScoreFields) {
    EXPECT_EQ(table.mean.*field.value, 2.0);
    EXPECT_EQ(table.worst.*field.value, field.less_is_better ? 3.0 : 1.0) << field.name;
  }
}

TEST(ScoreTable, TextHasALineAViewAndJsonHasNullForTheInfinite) {
  ViewScore score = score_of(0.25);
  score.edge_ratio = std::numeric_limits<double>::infinity();
  const ScoreTable table = tabulate({{"a.png", score}});
  const std::string text = table_text(table);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  const auto json = table_json(table);
  EXPECT_EQ(json["views"]["a.png"]["psnr"], 0.25);
  EXPECT_TRUE(json["mean"]["edge_ratio"].is_null());
}

}  // namespace
}  // namespace bosk
