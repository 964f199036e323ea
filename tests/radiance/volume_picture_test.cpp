#include "core/radiance/volume_picture.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "core/radiance/photo_residuals.h"
#include "tests/opacity/ball_scene.h"

namespace bosk {
namespace {

constexpr float kExtinction = 0.05f;  // per cell edge
const glm::vec3 kGreen(51.0f / 255.0f, 153.0f / 255.0f, 0.0f);

// 16 of 32 cells each way, all alike: light along an axis keeps exp(-16 * 0.05).
RadianceVolume even_block() {
  std::vector<glm::ivec3> cells;
  for (int i = 0; i < 4096; ++i) cells.emplace_back(8 + i % 16, 8 + i / 16 % 16, 8 + i / 256);
  RadianceVolume volume{glm::dvec3(-1.0), 2.0, SparseGrid(5, cells), 0, {}, {}};
  volume.extinction.assign(4096, kExtinction);
  for (int i = 0; i < 4096; ++i)
    volume.colour.insert(volume.colour.end(), {kGreen.r, kGreen.g, kGreen.b});
  return volume;
}

TEST(VolumePicture, LightThatCrossesABlockIsKeptByTheExponentialLaw) {
  const VolumeSnapshot block = snapshot_of(even_block());
  const Camera camera = orbit_camera(block, 0.0, 0.0, 20.0, 64, 64, 0.08);
  const Image<glm::u8vec4> picture = volume_picture(block, camera, 32, 32);
  const double alpha = double(picture(16, 16).a) / 255.0;
  // The steps are one cell, and rays start anywhere within one: off by less than a step's depth.
  EXPECT_NEAR(-std::log(1.0 - alpha), 16.0 * double(kExtinction), double(kExtinction));
  EXPECT_EQ(picture(0, 0).a, 0);
}

TEST(VolumePicture, ShowsStraightColour) {
  const VolumeSnapshot block = snapshot_of(even_block());
  const Camera camera = orbit_camera(block, 0.4, 0.3, 2.0, 40, 40);
  const Image<glm::u8vec4> picture = volume_picture(block, camera, 40, 40);
  int shown = 0;
  for (const glm::u8vec4& pixel : picture.pixels()) {
    if (pixel.a == 0) continue;
    ++shown;
    EXPECT_NEAR(pixel.r, 51, 1);  // one for rounding
    EXPECT_NEAR(pixel.g, 153, 1);
    EXPECT_EQ(pixel.b, 0);
  }
  EXPECT_GT(shown, 100);
}

TEST(VolumePicture, GivesTheSameWithOneThreadAndMany) {
  const VolumeSnapshot block = snapshot_of(even_block());
  const Camera camera = orbit_camera(block, 0.4, 0.3, 2.0, 60, 40);
  const Image<glm::u8vec4> many = volume_picture(block, camera, 60, 40);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(volume_picture(block, camera, 60, 40), many);
}

TEST(OrbitCamera, LooksAtTheMiddleWithZUpwards) {
  const VolumeSnapshot block = snapshot_of(even_block());
  const Camera camera = orbit_camera(block, 1.0, 0.5, 2.0, 80, 60);
  const auto centre = project(camera, block.bounds.centre());
  const auto above = project(camera, block.bounds.centre() + glm::dvec3(0.0, 0.0, 0.3));
  ASSERT_TRUE(centre && above);
  EXPECT_NEAR(centre->x, 39.5, 1e-9);
  EXPECT_NEAR(centre->y, 29.5, 1e-9);
  EXPECT_NEAR(above->x, 39.5, 1e-9);
  EXPECT_LT(above->y, centre->y);
}

TEST(OrbitCamera, ShowsAllOfTheVolumeWhateverThePicturesShape) {
  const VolumeSnapshot block = snapshot_of(even_block());
  for (const glm::ivec2 size : {glm::ivec2(80, 60), glm::ivec2(40, 160)}) {
    const Camera camera = orbit_camera(block, 0.7, 0.3, 2.7, size.x, size.y);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 part(corner & 1, corner >> 1 & 1, corner >> 2);
      const auto seen = project(camera, block.bounds.lower + part * block.bounds.size());
      ASSERT_TRUE(seen);
      EXPECT_GT(seen->x, -0.5);
      EXPECT_LT(seen->x, size.x - 0.5);
      EXPECT_GT(seen->y, -0.5);
      EXPECT_LT(seen->y, size.y - 0.5);
    }
  }
}

TEST(SlicePicture, ShowsACellAtItsPlace) {
  // Two corners of the bounds, and one cell near the lower corner in x, high in y and z.
  const OpacityTree tree{glm::dvec3(0.0),
                         16.0,
                         SparseGrid(4, {{0, 0, 0}, {1, 13, 14}, {15, 15, 15}}),
                         {0.0f, 10.0f, 0.0f}};
  const VolumeSnapshot volume = snapshot_of(tree);
  const auto brightest = [](const Image<glm::u8vec4>& picture) {
    glm::ivec2 best(0);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        if (picture(x, y).g > picture(best.x, best.y).g) best = {x, y};
      }
    }
    return best;
  };
  const auto cut = [&](int axis, double position) {
    return brightest(slice_picture(volume, axis, position, 16, SliceLook::extinction));
  };
  EXPECT_EQ(cut(0, 1.5 / 16), glm::ivec2(13, 1));  // y to the right, z upwards
  EXPECT_EQ(cut(1, 13.5 / 16), glm::ivec2(1, 1));  // x to the right, z upwards
  EXPECT_EQ(cut(2, 14.5 / 16), glm::ivec2(1, 2));  // x to the right, y upwards
}

TEST(PhotoResiduals, TellTheRightVolumeFromAMovedOne) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  const Mattes mattes = mattes_of(scene, photos);
  OpacityOptions options;
  options.finest_level = 5;
  options.passes = 3;
  Progress progress;
  OpacityTree tree = estimate_opacity(photos, mattes, options, progress);
  const auto small = small_mattes(photos, mattes, 32);
  EXPECT_EQ(small[0].premultiplied.width(), 32);
  const auto right = photo_residuals(snapshot_of(tree), small);
  tree.origin.z += 0.5;
  const auto moved = photo_residuals(snapshot_of(tree), small);
  ASSERT_EQ(right.size(), 6u);
  for (std::size_t i = 0; i < right.size(); ++i) {
    EXPECT_EQ(right[i].name, photos[i].name);
    EXPECT_LT(right[i].alpha_error, 0.1);  // hard edges of the ball, a cell wide
    EXPECT_GT(moved[i].alpha_error, 2.0 * right[i].alpha_error);
    EXPECT_GT(right[i].psnr_db, moved[i].psnr_db);
  }
}

TEST(PhotoResiduals, OfAnEmptyVolumeAreTheMattesThemselves) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 2);
  const auto small = small_mattes(photos, mattes_of(scene, photos), 16);
  double sum = 0.0, count = 0.0;
  for (const glm::vec4& pixel : small[1].premultiplied.pixels()) {
    sum += double(pixel.a), count += pixel.a > 0.0f ? 1.0 : 0.0;
  }
  const VolumeSnapshot empty =
      snapshot_of(OpacityTree{glm::dvec3(0.0), 1.0, SparseGrid(4, {}), {}});
  EXPECT_NEAR(photo_residuals(empty, small)[1].alpha_error, sum / count, 1e-12);
}

}  // namespace
}  // namespace bosk
