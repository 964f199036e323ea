#include "core/photo/resample.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <functional>
#include <numbers>

#include "core/base/error.h"
#include "core/image/colour.h"

namespace bosk {
namespace {

// Single precision through the sRGB curve and back, in linear light near 1.
constexpr float kRounding = 2e-6f;

Lens pinhole(int width, int height, double focal) {
  Lens lens;
  lens.width_px = width;
  lens.height_px = height;
  lens.focal_px = glm::dvec2(focal);
  lens.principal_px = glm::dvec2(0.5 * (width - 1) + 1.3, 0.5 * (height - 1) - 0.7);
  return lens;
}

Lens barrel(int width, int height, double focal) {
  Lens lens = pinhole(width, height, focal);
  lens.model = LensModel::opencv;
  lens.distortion = {-0.12, 0.02, 0.001, -0.002};
  return lens;
}

// A photo of linear light given by a formula.
DecodedPhoto photo_of(const Lens& lens, int channels,
                      const std::function<float(int, int, int)>& at) {
  DecodedPhoto photo;
  photo.width_px = lens.width_px;
  photo.height_px = lens.height_px;
  photo.channels = channels;
  photo.kind = PixelKind::f32_linear;
  for (int y = 0; y < lens.height_px; ++y) {
    for (int x = 0; x < lens.width_px; ++x) {
      for (int c = 0; c < channels; ++c) {
        const float value = at(x, y, c);
        const auto* first = reinterpret_cast<const std::byte*>(&value);
        photo.pixels.insert(photo.pixels.end(), first, first + sizeof(float));
      }
    }
  }
  return photo;
}

float slope(double x, double y) { return float(0.1 + 0.002 * x + 0.003 * y); }

// Resamples a slope and compares each pixel with the slope where the lenses say it was seen.
void expect_slope_in_place(const Lens& original, const Lens& working) {
  const DecodedPhoto photo = photo_of(original, 3, [](int x, int y, int) { return slope(x, y); });
  const Image<glm::vec4> result = undistorted_photo(photo, original, working);
  int checked = 0;
  for (int y = 0; y < working.height_px; ++y) {
    for (int x = 0; x < working.width_px; ++x) {
      const auto seen = pixel_from_camera(original, *camera_from_pixel(working, {x, y}));
      const double margin = 4.0 + double(original.width_px) / working.width_px;
      if (!seen || seen->x < margin || seen->y < margin ||
          seen->x > original.width_px - 1 - margin || seen->y > original.height_px - 1 - margin) {
        continue;
      }
      ++checked;
      ASSERT_NEAR(linear_from_srgb(result(x, y).g), slope(seen->x, seen->y), kRounding);
    }
  }
  EXPECT_GT(checked, working.width_px * working.height_px / 2);
}

TEST(ResamplingWeight, SumsToOneAtEveryScaleAndPlace) {
  for (const double scale : {1.0, 1.01, 1.7, 4.9, 12.0}) {
    for (const double start : {0.0, 0.3, 0.5, 0.99}) {
      double sum = 0.0;
      for (int i = -20; i <= 20; ++i) sum += resampling_weight(i + start, scale);
      EXPECT_NEAR(sum, 1.0, 1e-12);
      EXPECT_EQ(resampling_weight(resampling_radius(scale) + 1e-9, scale), 0.0);
    }
  }
}

TEST(ResamplingWeight, TouchesNothingWhereNothingMoves) {
  EXPECT_EQ(resampling_weight(0.0, 1.0), 1.0);
  for (int i = 1; i < 4; ++i) EXPECT_EQ(resampling_weight(i, 1.0), 0.0);
}

TEST(UndistortedPhoto, PutsEveryPixelWhereTheLensSawIt) {
  const Lens original = barrel(120, 90, 110.0);
  expect_slope_in_place(original, undistorted(original));
  expect_slope_in_place(original, undistorted(scaled(original, 60, 45)));
  expect_slope_in_place(original, undistorted(scaled(original, 35, 26)));
}

TEST(UndistortedPhoto, CopiesWhatNeedsNoChange) {
  Lens lens = pinhole(20, 10, 30.0);
  DecodedPhoto photo;
  photo.width_px = 20;
  photo.height_px = 10;
  for (int i = 0; i < 600; ++i) photo.pixels.push_back(std::byte(i * 37));
  EXPECT_EQ(undistorted_photo(photo, lens, lens), straight_of(photo));
  Lens same = lens;
  same.model = LensModel::opencv;
  EXPECT_EQ(undistorted_photo(photo, same, lens), straight_of(photo));
}

float wave(double x) { return float(0.5 + 0.4 * std::cos(0.4 * std::numbers::pi * x + 0.3)); }

// A wave of 5 pixels moved by 0.3: Catmull-Rom within its bounds errs a third as much as bilinear
// would.
TEST(UndistortedPhoto, KeepsFineDetailBetterThanBilinear) {
  const Lens original = pinhole(64, 16, 50.0);
  Lens working = original;
  working.principal_px.x -= 0.3;
  const DecodedPhoto photo = photo_of(original, 3, [](int x, int, int) { return wave(x); });
  const Image<glm::vec4> result = undistorted_photo(photo, original, working);
  double error = 0.0, bilinear_error = 0.0;
  for (int x = 10; x < 54; ++x) {
    const float truth = wave(x + 0.3);
    error += std::pow(linear_from_srgb(result(x, 8).r) - truth, 2);
    bilinear_error += std::pow(0.7f * wave(x) + 0.3f * wave(x + 1) - truth, 2);
  }
  EXPECT_LT(error, 0.4 * 0.4 * bilinear_error);
}

TEST(UndistortedPhoto, RingsNeitherDarkerNorBrighterBesideASkyline) {
  const Lens original = barrel(100, 80, 90.0);
  const DecodedPhoto photo =
      photo_of(original, 3, [](int x, int y, int) { return x + y < 90 ? 0.9f : 0.05f; });
  for (const int width : {100, 77, 30}) {
    const Lens working = undistorted(scaled(original, width, width * 4 / 5));
    const Image<glm::vec4> result = undistorted_photo(photo, original, working);
    for (const glm::vec4& pixel : result.pixels()) {
      ASSERT_GE(linear_from_srgb(pixel.r), 0.05f - kRounding);
      ASSERT_LE(linear_from_srgb(pixel.r), 0.9f + kRounding);
    }
  }
}

TEST(UndistortedPhoto, KeepsTheMeanLightWhenItShrinks) {
  const Lens original = pinhole(120, 80, 100.0);
  const DecodedPhoto photo = photo_of(original, 3, [](int x, int y, int) {
    return x > 30 && x < 90 && y > 20 && y < 60 && (x * 7 + y * 13) % 5 == 0 ? 1.0f : 0.2f;
  });
  double mean = 0.0, small_mean = 0.0;
  const Image<glm::vec3> whole = srgb_of(photo);
  for (const glm::vec3& pixel : whole.pixels()) mean += linear_from_srgb(pixel.r) / 9600;
  const Image<glm::vec4> small = undistorted_photo(photo, original, scaled(original, 30, 20));
  for (const glm::vec4& pixel : small.pixels()) small_mean += linear_from_srgb(pixel.r) / 600;
  // The kernel's weights sum to 1 over the results only in the mean: a few parts in a thousand
  EXPECT_NEAR(small_mean, mean, 0.002);
}

TEST(UndistortedPhoto, LetsNoColourBleedFromClearPixels) {
  const Lens original = barrel(80, 60, 70.0);
  const DecodedPhoto photo = photo_of(original, 4, [](int x, int y, int c) {
    const bool leaf = (x / 3 + y / 3) % 2 == 0;
    if (c == 3) return leaf ? 1.0f : 0.0f;
    return leaf == (c == 1) ? 0.5f : 0.0f;  // green leaf; magenta where clear
  });
  const Image<glm::vec4> result =
      undistorted_photo(photo, original, undistorted(scaled(original, 50, 38)));
  for (const glm::vec4& pixel : result.pixels()) {
    if (pixel.a < 0.05f) continue;
    // Clear pixels count with a trace of 1e-6, beside an alpha of 0.05 and a lobe of some tenths
    ASSERT_LT(linear_from_srgb(pixel.r), 1e-3f);
    ASSERT_NEAR(linear_from_srgb(pixel.g), 0.5f, 2e-3f);
  }
}

TEST(UndistortRgba, MapsAMatteExactlyLikeItsPhoto) {
  const Lens original = barrel(80, 60, 70.0);
  const Camera taken{"a", original, {}}, working{"a", undistorted(scaled(original, 50, 38)), {}};
  const DecodedPhoto photo = photo_of(original, 4, [](int x, int y, int c) {
    return float((x * 5 + y * 11 + c * 3) % 17) / 16.0f;
  });
  const Image<glm::vec4> from_photo = undistorted_photo(photo, original, working.lens);
  const Image<glm::vec4> from_matte = undistort_rgba(straight_of(photo), taken, working);
  for (std::size_t i = 0; i < from_photo.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      ASSERT_NEAR(from_photo.pixels()[i][c], from_matte.pixels()[i][c], 5e-5f);
    }
  }
}

TEST(UndistortRgba, TakesAMatteThatWasScaledDown) {
  const Lens original = barrel(80, 60, 70.0);
  const Camera taken{"a", original, {}}, working{"a", undistorted(original), {}};
  const Image<glm::vec4> half(40, 30, glm::vec4(0.5f));
  EXPECT_NEAR(undistort_rgba(half, taken, working)(40, 30).a, 0.5f, 1e-5f);
  EXPECT_THROW(undistort_rgba(Image<glm::vec4>(40, 40), taken, working), Error);
}

TEST(LensForSize, AcceptsTheSameShapeOnly) {
  const Lens lens = pinhole(6000, 4000, 5000.0);
  EXPECT_EQ(lens_for_size(lens, 6000, 4000), lens);
  EXPECT_DOUBLE_EQ(lens_for_size(lens, 1500, 1000).focal_px.x, 1250.0);
  EXPECT_NO_THROW(lens_for_size(lens, 1225, 817));
  EXPECT_THROW(lens_for_size(lens, 4000, 6000), Error);
  EXPECT_THROW(lens_for_size(lens, 4000, 3000), Error);
  EXPECT_THROW(lens_for_size(Lens{}, 4000, 3000), Error);
}

TEST(UndistortedPhoto, SameWithOneThreadAndMany) {
  const Lens original = barrel(120, 90, 110.0);
  const DecodedPhoto photo = photo_of(
      original, 3, [](int x, int y, int c) { return float((x * 31 + y * 17 + c) % 101) / 100.0f; });
  const Lens working = undistorted(scaled(original, 70, 52));
  const Image<glm::vec4> many = undistorted_photo(photo, original, working);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(undistorted_photo(photo, original, working), many);
}

}  // namespace
}  // namespace bosk
