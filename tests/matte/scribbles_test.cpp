#include "core/matte/scribbles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace bosk {
namespace {

Photo bent_photo() {
  Photo photo;
  photo.name = "oak";
  photo.original_camera.lens = {LensModel::opencv,       200,         150, glm::dvec2(180.0),
                                glm::dvec2(101.0, 73.0), {-0.2, 0.05}};
  photo.camera.lens = undistorted(photo.original_camera.lens);
  return photo;
}

Image<std::uint8_t> both_kinds(int width, int height) {
  Image<std::uint8_t> drawn(width, height, kNoStroke);
  drawn(width / 2, height / 2) = kForegroundStroke;
  drawn(width / 2, height / 4) = kBackgroundStroke;
  return drawn;
}

// As a project takes a file of strokes that stands alone.
Image<std::uint8_t> scribbles_in_photo(const Image<std::uint8_t>& drawn, const Photo& photo,
                                       const std::string& file) {
  Image<std::uint8_t> strokes = drawing_in_photo(drawn, photo, file);
  require_both_kinds(strokes, file);
  return strokes;
}

std::string complaint_about(const Image<std::uint8_t>& drawn) {
  try {
    scribbles_in_photo(drawn, bent_photo(), "oak.png");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ScribblesInPhoto, GoWhereTheLensBendsThem) {
  const Photo photo = bent_photo();
  Image<std::uint8_t> drawn(200, 150, kBackgroundStroke);
  for (int y = 118; y <= 122; ++y) {
    for (int x = 18; x <= 22; ++x) drawn(x, y) = kForegroundStroke;
  }
  const Image<std::uint8_t> strokes = scribbles_in_photo(drawn, photo, "oak.png");
  const auto ray = camera_from_pixel(photo.original_camera.lens, {20.0, 120.0});
  ASSERT_TRUE(ray);
  const auto there = pixel_from_camera(photo.camera.lens, *ray);
  ASSERT_TRUE(there);
  EXPECT_GT(glm::distance(*there, glm::dvec2(20.0, 120.0)), 3.0);  // else the lens would not matter
  EXPECT_EQ(strokes(int(std::lround(there->x)), int(std::lround(there->y))), kForegroundStroke);
  EXPECT_EQ(strokes(int(std::lround(there->x)) + 12, int(std::lround(there->y))),
            kBackgroundStroke);
}

TEST(ScribblesInPhoto, TakeScaledCopies) {
  Photo photo = bent_photo();
  photo.original_camera.lens = photo.camera.lens;
  Image<std::uint8_t> drawn(400, 300, kNoStroke);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) drawn(x, y) = x < 200 ? kForegroundStroke : kBackgroundStroke;
  }
  const Image<std::uint8_t> strokes = scribbles_in_photo(drawn, photo, "oak.png");
  EXPECT_EQ(strokes(95, 70), kForegroundStroke);
  EXPECT_EQ(strokes(104, 70), kBackgroundStroke);
}

TEST(ScribblesInPhoto, CountSoftStrokeEdgesAsUnknown) {
  Photo photo = bent_photo();
  photo.original_camera.lens = photo.camera.lens;
  Image<std::uint8_t> drawn = both_kinds(200, 150);
  drawn(10, 10) = 200;
  drawn(11, 10) = 60;
  drawn(12, 10) = 250;
  drawn(13, 10) = 6;
  const Image<std::uint8_t> strokes = scribbles_in_photo(drawn, photo, "oak.png");
  EXPECT_EQ(strokes(10, 10), kNoStroke);
  EXPECT_EQ(strokes(11, 10), kNoStroke);
  EXPECT_EQ(strokes(12, 10), kForegroundStroke);
  EXPECT_EQ(strokes(13, 10), kBackgroundStroke);
}

TEST(ScribblesInPhoto, RefuseStrokesOfOneKindAndNameTheFile) {
  Image<std::uint8_t> white = both_kinds(200, 150);
  white(100, 37) = kNoStroke;
  EXPECT_THAT(complaint_about(white),
              testing::AllOf(testing::HasSubstr("oak.png"), testing::HasSubstr("black")));
  Image<std::uint8_t> black = both_kinds(200, 150);
  black(100, 75) = kNoStroke;
  EXPECT_THAT(complaint_about(black),
              testing::AllOf(testing::HasSubstr("oak.png"), testing::HasSubstr("white")));
  EXPECT_THAT(complaint_about(Image<std::uint8_t>(200, 150, kNoStroke)),
              testing::HasSubstr("no strokes"));
}

TEST(ScribblesInPhoto, RefuseAnotherShape) {
  EXPECT_THAT(complaint_about(both_kinds(150, 200)), testing::HasSubstr("150 x 200"));
  EXPECT_THAT(complaint_about(Image<std::uint8_t>()), testing::HasSubstr("oak.png"));
  EXPECT_EQ(complaint_about(both_kinds(100, 75)), "");
}

}  // namespace
}  // namespace bosk
