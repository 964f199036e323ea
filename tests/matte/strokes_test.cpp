#include "core/matte/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/matte/scribbles.h"

namespace bosk {
namespace {

// Its working photo is smaller than the photo as taken, and straight where that is bent.
Photo bent_photo(int working_width = 200, double k1 = -0.2) {
  Photo photo;
  photo.name = "oak";
  photo.original_camera.lens = {LensModel::opencv,        400,       300, glm::dvec2(360.0),
                                glm::dvec2(203.0, 146.0), {k1, 0.05}};
  photo.camera.lens =
      scaled(undistorted(photo.original_camera.lens), working_width, working_width * 3 / 4);
  return photo;
}

Photo plain_photo(int width, int height) {
  Photo photo;
  photo.original_camera.lens = {LensModel::pinhole,
                                width,
                                height,
                                glm::dvec2(width),
                                0.5 * glm::dvec2(width - 1, height - 1),
                                {}};
  photo.camera.lens = photo.original_camera.lens;
  return photo;
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const double length2 = glm::dot(b - a, b - a);
  const double t = length2 == 0.0 ? 0.0 : std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0);
  return glm::distance(p, a + t * (b - a));
}

bool lies_within(const Stroke& stroke, const glm::dvec2& place) {
  double nearest = glm::distance(place, stroke.points_px.front());
  for (std::size_t i = 1; i < stroke.points_px.size(); ++i) {
    nearest =
        std::min(nearest, distance_to_segment(place, stroke.points_px[i - 1], stroke.points_px[i]));
  }
  return nearest <= stroke.radius_px;
}

// Pixel by pixel and stroke by stroke, as the declaration says.
Image<std::uint8_t> painted_slowly(const std::vector<Stroke>& strokes, const Photo& photo) {
  const Lens& working = photo.camera.lens;
  const Lens& original = photo.original_camera.lens;
  Image<std::uint8_t> scribbles(working.width_px, working.height_px, kNoStroke);
  for (int y = 0; y < scribbles.height(); ++y) {
    for (int x = 0; x < scribbles.width(); ++x) {
      const auto place = pixel_from_camera(
          original, {(glm::dvec2(x, y) - working.principal_px) / working.focal_px, 1.0});
      if (!place || place->x < -0.5 || place->y < -0.5 || place->x >= original.width_px - 0.5 ||
          place->y >= original.height_px - 0.5) {
        continue;
      }
      for (const Stroke& stroke : strokes) {
        if (!lies_within(stroke, *place)) continue;
        scribbles(x, y) = stroke.kind == StrokeKind::erase        ? kNoStroke
                          : stroke.kind == StrokeKind::foreground ? kForegroundStroke
                                                                  : kBackgroundStroke;
      }
    }
  }
  return scribbles;
}

Image<std::uint8_t> painted(const std::vector<Stroke>& strokes, const Photo& photo) {
  Image<std::uint8_t> scribbles;
  paint_strokes(strokes, photo, scribbles);
  return scribbles;
}

Stroke random_stroke(Random& random) {
  Stroke stroke;
  stroke.kind = StrokeKind(random.below(3));
  stroke.radius_px = 0.5 + 30.0 * random.uniform() * random.uniform();
  glm::dvec2 place(500.0 * random.uniform() - 50.0, 400.0 * random.uniform() - 50.0);
  for (auto left = 1 + random.below(60); left > 0; --left) {
    stroke.points_px.push_back(place);
    place += glm::dvec2(20.0 * random.uniform() - 10.0, 20.0 * random.uniform() - 10.0);
  }
  return rounded_stroke(stroke);
}

std::size_t count(const Image<std::uint8_t>& scribbles, std::uint8_t value) {
  return std::size_t(std::count(scribbles.pixels().begin(), scribbles.pixels().end(), value));
}

TEST(PaintStrokes, PaintsThePixelsThatTheDeclarationNames) {
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Photo photo = bent_photo(i % 3 == 0 ? 400 : 130, i % 2 == 0 ? -0.2 : 0.1);
    std::vector<Stroke> strokes;
    for (int k = 0; k < 1 + i % 12; ++k) strokes.push_back(random_stroke(random));
    EXPECT_EQ(painted(strokes, photo), painted_slowly(strokes, photo)) << i;
  }
}

TEST(PaintStrokes, AStrokeOfOnePointIsADisc) {
  const Photo photo = plain_photo(100, 80);
  const auto scribbles = painted({{StrokeKind::foreground, 20.3, {{50.0, 40.0}}}}, photo);
  EXPECT_EQ(scribbles(50, 20), kForegroundStroke);
  EXPECT_EQ(scribbles(50, 19), kNoStroke);
  EXPECT_EQ(scribbles(30, 40), kForegroundStroke);
  EXPECT_EQ(scribbles(70, 60), kNoStroke);
  EXPECT_EQ(count(scribbles, kForegroundStroke), 1305u);  // whole points within 20.3 of one
}

TEST(PaintStrokes, GoOverWhatIsThereInTheOrderDrawn) {
  const Photo photo = plain_photo(60, 60);
  Image<std::uint8_t> scribbles(60, 60, kBackgroundStroke);
  paint_strokes({{StrokeKind::foreground, 10.0, {{30.0, 30.0}}},
                 {StrokeKind::erase, 5.0, {{30.0, 30.0}}},
                 {StrokeKind::foreground, 2.0, {{30.0, 30.0}}}},
                photo, scribbles);
  EXPECT_EQ(scribbles(30, 30), kForegroundStroke);
  EXPECT_EQ(scribbles(34, 30), kNoStroke);
  EXPECT_EQ(scribbles(38, 30), kForegroundStroke);
  EXPECT_EQ(scribbles(45, 30), kBackgroundStroke);
}

TEST(PaintStrokes, OneByOneOrAllAtOnceIsTheSame) {
  Random random(6);
  const Photo photo = bent_photo();
  std::vector<Stroke> strokes;
  Image<std::uint8_t> one_by_one;
  for (int i = 0; i < 40; ++i) {
    strokes.push_back(random_stroke(random));
    paint_strokes({strokes.back()}, photo, one_by_one);
  }
  EXPECT_EQ(one_by_one, painted(strokes, photo));
}

TEST(PaintStrokes, InTheBoxOfOneTakenOutGiveWhatPaintingAllAnewWould) {
  Random random(7);
  const Photo photo = bent_photo();
  const auto below = painted({random_stroke(random), random_stroke(random)}, photo);
  std::vector<Stroke> strokes;
  for (int i = 0; i < 30; ++i) strokes.push_back(random_stroke(random));
  auto scribbles = below;
  paint_strokes(strokes, photo, scribbles);
  while (!strokes.empty()) {
    const auto taken = strokes.begin() + std::ptrdiff_t(random.below(strokes.size()));
    const Stroke changed = *taken;
    strokes.erase(taken);
    const PixelBox box = box_of(changed, photo);
    for (int y = box.from.y; y < box.to.y; ++y) {
      for (int x = box.from.x; x < box.to.x; ++x) scribbles(x, y) = below(x, y);
    }
    paint_strokes(strokes, photo, box, scribbles);
    auto anew = below;
    paint_strokes(strokes, photo, anew);
    ASSERT_EQ(scribbles, anew) << strokes.size();
  }
  EXPECT_EQ(scribbles, below);
}

TEST(PaintStrokes, AgreeWithADrawingOfTheSame) {
  const Photo photo = bent_photo(400);
  const std::vector<Stroke> strokes = {
      {StrokeKind::background, 40.0, {{60.0, 40.0}, {350.0, 60.0}}},
      {StrokeKind::foreground, 30.0, {{200.0, 150.0}, {190.0, 260.0}}}};
  Image<std::uint8_t> drawn(400, 300, kNoStroke);
  Photo as_taken = photo;
  as_taken.camera.lens = as_taken.original_camera.lens = undistorted(photo.original_camera.lens);
  paint_strokes(strokes, as_taken, drawn);
  const auto through_file = drawing_in_photo(drawn, photo, "oak.png");
  const auto direct = painted(strokes, photo);
  std::size_t different = 0;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    different += direct.pixels()[i] != through_file.pixels()[i] ? 1 : 0;
  }
  // A drawing is taken at the nearest pixel, so edges may differ by half a pixel: at most half of
  // the edge pixels, and the two outlines are 2 * (291 + 110) + 2 pi (40 + 30), or 1242 px long
  EXPECT_LT(different, 621u);
  EXPECT_GT(count(direct, kForegroundStroke), 8000u);
}

TEST(PaintStrokes, WithinABoxPaintThatAlone) {
  const Photo photo = bent_photo();
  const std::vector<Stroke> strokes{{StrokeKind::foreground, 30.0, {{60, 70}, {300, 200}}},
                                    {StrokeKind::background, 12.0, {{100, 250}, {350, 40}}}};
  const Image<std::uint8_t> whole = painted_slowly(strokes, photo);
  Image<std::uint8_t> part(photo.camera.lens.width_px, photo.camera.lens.height_px, 7);
  const PixelBox box{{37, 41}, {121, 200}};
  paint_strokes(strokes, photo, box, part);
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) {
      const bool inside = x >= 37 && x < 121 && y >= 41;
      const int expected = inside && whole(x, y) != kNoStroke ? whole(x, y) : 7;
      ASSERT_EQ(int(part(x, y)), expected) << x << ", " << y;
    }
  }
}

void expect_in_box(const Stroke& stroke, const Photo& photo) {
  const Image<std::uint8_t> whole = painted_slowly({stroke}, photo);
  const PixelBox box = box_of(stroke, photo);
  for (int y = 0; y < whole.height(); ++y) {
    for (int x = 0; x < whole.width(); ++x) {
      if (whole(x, y) == kNoStroke) continue;
      ASSERT_TRUE(x >= box.from.x && x < box.to.x && y >= box.from.y && y < box.to.y)
          << x << ", " << y;
    }
  }
}

// A fast hand gives two places far apart; what lies between them is bent away from them.
TEST(BoxOf, HoldsTheBendOfALongLine) {
  for (const double k1 : {-0.2, 0.2}) {
    const Photo photo = bent_photo(400, k1);
    expect_in_box({StrokeKind::foreground, 3.0, {{10, 8}, {390, 8}}}, photo);
    expect_in_box({StrokeKind::foreground, 3.0, {{10, 290}, {390, 290}}}, photo);
    expect_in_box({StrokeKind::foreground, 3.0, {{8, 10}, {8, 290}}}, photo);
    expect_in_box({StrokeKind::foreground, 3.0, {{390, 10}, {390, 290}}}, photo);
  }
}

TEST(BoxOf, HoldsAllThatAStrokePaints) {
  const Photo photo = bent_photo();
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    Stroke stroke{StrokeKind::foreground, random.uniform(1.0, 60.0), {}};
    for (int k = 0; k < 3; ++k) {
      stroke.points_px.emplace_back(random.uniform(-50.0, 450.0), random.uniform(-50.0, 350.0));
    }
    SCOPED_TRACE(i);
    expect_in_box(stroke, photo);
  }
}

TEST(TakenPlace, GoesThereAndBack) {
  const Photo photo = bent_photo();
  for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(100, 75), glm::dvec2(190.5, 20)}) {
    const auto back = working_place(photo, *taken_place(photo, pixel));
    ASSERT_TRUE(back);
    EXPECT_LT(glm::distance(*back, pixel), 1e-6);
  }
  EXPECT_NEAR(taken_px_per_working_px(photo), 2.0, 1e-9);
}

TEST(RoundedStroke, KeepsSixteenthsOfAPixel) {
  const Stroke stroke =
      rounded_stroke({StrokeKind::erase, 3.03, {{10.04, -0.01}, {7.9375, 1e5 + 0.03}}});
  EXPECT_EQ(stroke.radius_px, 3.0);
  EXPECT_EQ(stroke.points_px[0], glm::dvec2(10.0625, 0.0));
  EXPECT_FALSE(std::signbit(stroke.points_px[0].y));
  EXPECT_EQ(stroke.points_px[1], glm::dvec2(7.9375, 1e5));
  EXPECT_EQ(rounded_stroke(stroke), stroke);
}

TEST(RoundedStroke, RefusesWhatIsNoStroke) {
  const auto refused = [](const Stroke& stroke) { EXPECT_THROW(rounded_stroke(stroke), Error); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  refused({StrokeKind::erase, 3.0, {}});
  refused({StrokeKind::erase, 0.0, {{1.0, 1.0}}});
  refused({StrokeKind::erase, nan, {{1.0, 1.0}}});
  refused({StrokeKind::erase, infinite, {{1.0, 1.0}}});
  refused({StrokeKind::erase, 3.0, {{nan, 1.0}}});
  refused({StrokeKind::erase, 3.0, {{1.0, -infinite}}});
  refused({StrokeKind::erase, 3.0, {{1.0, 2e6}}});
  refused({StrokeKind::erase, 3.0, std::vector<glm::dvec2>(kMaxStrokePoints + 1)});
  EXPECT_NO_THROW(
      rounded_stroke({StrokeKind::erase, 3.0, std::vector<glm::dvec2>(kMaxStrokePoints)}));
}

}  // namespace
}  // namespace bosk
