#include "core/phantom/phantom.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/image/colour.h"
#include "core/phantom/scribbles.h"

namespace bosk {
namespace {

Phantom made(const PhantomOptions& options) {
  Progress progress;
  return make_phantom(options, progress);
}

const Phantom& tiny() {
  static const Phantom phantom = made(tiny_phantom());
  return phantom;
}

TEST(MakePhantom, GivesTheSamePicturesWithOneThreadAndMany) {
  PhantomOptions options = tiny_phantom();
  options.photos = 2;
  options.held_out = 1;
  options.wind_m = 0.05;
  options.exposure_drift = 0.2;
  const auto photographed = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return made(options);
  };
  const Phantom one = photographed(1), many = photographed(8);
  for (std::size_t i = 0; i < one.photos.size(); ++i) {
    EXPECT_EQ(one.photos[i].photograph, many.photos[i].photograph);
    EXPECT_EQ(one.photos[i].matte, many.photos[i].matte);
  }
  EXPECT_EQ(one.held_out[0].matte, many.held_out[0].matte);
  EXPECT_EQ(one.density.leaf_area, many.density.leaf_area);
}

TEST(MakePhantom, ShowsTheWholeTreeAndFillsThePictureWithIt) {
  for (const PhantomView& view : tiny().photos) {
    const int width = view.matte.width(), height = view.matte.height();
    int left = width, right = 0, top = height, bottom = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (view.matte(x, y).a == 0) continue;
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
    }
    EXPECT_GT(left, 0);
    EXPECT_GT(top, 0);
    EXPECT_LT(right, width - 1);
    EXPECT_LT(bottom, height - 1);
    EXPECT_GT(std::max(double(right - left) / width, double(bottom - top) / height), 0.75);
  }
}

TEST(MakePhantom, TurnsTheHeldOutViewsBetweenThePhotos) {
  ASSERT_EQ(tiny().held_out.size(), 2u);
  for (const PhantomView& held_out : tiny().held_out) {
    for (const PhantomView& photo : tiny().photos) {
      const glm::dvec3 a = held_out.camera.centre_in_world(), b = photo.camera.centre_in_world();
      EXPECT_GT(glm::distance(a, b), 0.05);
    }
  }
  const glm::dvec3 raised = tiny().held_out[1].camera.centre_in_world();
  EXPECT_GT(raised.z, 1.0 + 0.1 * glm::length(raised));
}

TEST(MakePhantom, SaysWhichMarkersShow) {
  int shown = 0;
  for (const PhantomView& view : tiny().photos) {
    ASSERT_EQ(view.marker_px.size(), 6u);
    for (std::size_t i = 0; i < view.marker_px.size(); ++i) {
      if (view.marker_visible[i] < 0.99) continue;
      const glm::ivec2 at(glm::round(view.marker_px[i]));
      EXPECT_GT(view.in_front(at.x, at.y), 64);  // a ball is 1 to 2 px wide here
      ++shown;
    }
  }
  EXPECT_GT(shown, 10);
}

TEST(MakePhantom, ShowsTheCornersOfABoardWhereTheyAre) {
  PhantomOptions options = tiny_phantom();
  options.photos = 1;
  options.held_out = 0;
  options.board_photos = 3;
  options.noise = 0.0;
  options.width_px = 240;
  options.height_px = 180;
  const Phantom phantom = made(options);
  ASSERT_EQ(phantom.board_photos.size(), 3u);
  int checked = 0;
  for (const PhantomView& view : phantom.board_photos) {
    for (int row = 1; row + 1 < phantom.board.rows - 1; ++row) {
      for (int column = 1; column + 1 < phantom.board.columns - 1; ++column) {
        const auto brightness = [&](double dx, double dy) {
          const glm::dvec3 on_board(column + dx, row + dy, 0.0);
          const auto pixel = project(
              view.camera, phantom.board.world_from_board * (phantom.board.square * on_board));
          if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x > 239 || pixel->y > 179) return -1;
          return int(view.photograph(int(std::lround(pixel->x)), int(std::lround(pixel->y))).g);
        };
        const int a = brightness(-0.4, -0.4), b = brightness(0.4, -0.4), c = brightness(-0.4, 0.4),
                  d = brightness(0.4, 0.4);
        if (std::min({a, b, c, d}) < 0) continue;
        EXPECT_GT(std::abs(a - b), 40);
        EXPECT_EQ(a > b, d > c);
        EXPECT_EQ(a > b, d > b);
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 60);
}

TEST(MakePhantom, DrawsExposureAndWindPerPhoto) {
  PhantomOptions options = tiny_phantom();
  options.photos = 2;
  options.held_out = 0;
  const Phantom still = made(options);
  options.exposure_drift = 0.3;
  options.wind_m = 0.1;
  const Phantom moved = made(options);
  EXPECT_EQ(still.photos[0].exposure, 1.0);
  EXPECT_NE(moved.photos[0].exposure, moved.photos[1].exposure);
  EXPECT_NE(still.photos[0].matte, moved.photos[0].matte);
  EXPECT_EQ(still.photos[0].camera.lens, moved.photos[0].camera.lens);
}

TEST(MakePhantom, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(make_phantom(tiny_phantom(), progress), Cancelled);
}

TEST(Scribbles, StayOnTheTreeAndClearOfIt) {
  const PhantomView& view = tiny().photos[0];
  const Image<std::uint8_t> strokes = draw_scribbles(view, 1);
  int tree = 0, background = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const int alpha = view.matte.pixels()[i].a;
    if (strokes.pixels()[i] == 255) {
      EXPECT_GE(alpha, 242);  // 0.95
      ++tree;
    } else if (strokes.pixels()[i] == 0) {
      EXPECT_EQ(alpha, 0);
      ++background;
    } else {
      EXPECT_EQ(strokes.pixels()[i], 128);
    }
  }
  EXPECT_GT(tree, 20);
  EXPECT_GT(background, 100);
}

TEST(PinholePhotos, CarryThePicturesAndCameras) {
  PhantomOptions options = tiny_phantom();
  options.distortion = 0.0;
  options.photos = 2;
  options.held_out = 0;
  const Phantom phantom = made(options);
  const Photos photos = pinhole_photos(phantom);
  ASSERT_EQ(photos.size(), 2u);
  EXPECT_EQ(photos[1].name, "001");
  EXPECT_EQ(photos[1].camera.lens.model, LensModel::pinhole);
  EXPECT_EQ(photos[1].srgb.width(), 96);
  const Image<glm::vec4> matte = straight_matte(phantom.photos[1]);
  EXPECT_EQ(matte(48, 64).a, float(phantom.photos[1].matte(48, 64).a) / 255.0f);
}

}  // namespace
}  // namespace bosk
