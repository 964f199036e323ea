#include "core/radiance/radiance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/base/error.h"
#include "march.h"
#include "tests/opacity/ball_scene.h"

namespace bosk {
namespace {

BallScene two_colours() {
  BallScene scene;
  scene.extinction = 6.0;
  scene.split = true;
  return scene;
}

OpacityTree opacity_of(const Photos& photos, const Mattes& mattes) {
  OpacityOptions options;
  options.finest_level = 4;
  Progress progress;
  return estimate_opacity(photos, mattes, options, progress);
}

RadianceVolume refined_ball(const BallScene& scene, int photo_count, int degree,
                            double max_samples = 0.0) {
  const Photos photos = ring_photos(scene, photo_count);
  const Mattes mattes = mattes_of(scene, photos);
  RadianceOptions options;
  options.degree = degree;
  options.max_samples = max_samples;
  Progress progress;
  return refine_radiance(photos, mattes, opacity_of(photos, mattes), options, progress);
}

MarchError error_of_view(const BallScene& scene, const RadianceVolume& volume, double turn) {
  Photos photos{Photo{}};
  photos[0].camera = camera_at(ring_place(scene, turn, 0.0), scene.centre());
  const TrilinearSupport support(volume.grid);
  Progress progress;
  const RayCache cache =
      cache_rays(photos, mattes_of(scene, photos), 1, {volume.origin, volume.size_m},
                 volume.grid.level(), support, progress);
  return march_error(volume, cache, support);
}

TEST(RefineRadiance, ShowsATwoColouredBallFromViewsItDidNotSee) {
  const BallScene scene = two_colours();
  const RadianceVolume volume = refined_ball(scene, 12, 0);
  for (const double turn : {0.7, 2.4, 4.0}) {
    const MarchError error = error_of_view(scene, volume, turn);
    // A fine cell is 1.7 px: rim (140 px around) and seam blur over about one cell.
    EXPECT_LT(error.colour, 0.06) << "turn " << turn;
    EXPECT_LT(error.alpha, 0.08) << "turn " << turn;
  }
}

TEST(RefineRadiance, AveragesPhotosWhenTheyHaveMoreSamplesThanAllowed) {
  const BallScene scene = two_colours();
  const RadianceVolume all = refined_ball(scene, 6, 0);
  // About 6 x 45^2 rays of up to 16 samples: 0.15 million.
  EXPECT_EQ(refined_ball(scene, 6, 0, 1.0).extinction, all.extinction);  // to the bit: all rays
  const RadianceVolume halved = refined_ball(scene, 6, 0, 0.06);
  EXPECT_NE(halved.extinction, all.extinction);
  // A pixel of the halved photos is 1.2 cells of 1.7 px wide: about twice the blur of all pixels.
  EXPECT_LT(error_of_view(scene, halved, 0.7).colour, 0.12);
}

TEST(RefineRadiance, RunsAtEveryDegree) {
  for (const int degree : {1, 2}) {
    const RadianceVolume volume = refined_ball(two_colours(), 6, degree);
    EXPECT_EQ(volume.colour.size(),
              volume.grid.size() * 3 * std::size_t((degree + 1) * (degree + 1)));
    EXPECT_LT(error_of_view(two_colours(), volume, 0.7).colour, 0.12);  // half the photos
  }
}

TEST(RefineRadiance, ReachesTheFinerLevelAndDropsFaintCells) {
  const RadianceVolume volume = refined_ball(two_colours(), 6, 0);
  EXPECT_EQ(volume.grid.level(), 5);
  const float least = 0.5f * float(RadianceOptions{}.faintest);  // of the last stretch
  for (const float value : volume.extinction) EXPECT_GE(value, least);
}

TEST(RefineRadiance, GivesTheSameWithOneThreadAndMany) {
  const RadianceVolume many = refined_ball(two_colours(), 6, 0);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const RadianceVolume single = refined_ball(two_colours(), 6, 0);
  EXPECT_EQ(many.grid.cells(), single.grid.cells());
  EXPECT_EQ(many.extinction, single.extinction);  // to the bit
  EXPECT_EQ(many.colour, single.colour);
}

TEST(RefineRadiance, CountsEpochsOneByOneOverAllLevels) {
  const BallScene scene = two_colours();
  const Photos photos = ring_photos(scene, 6);
  const Mattes mattes = mattes_of(scene, photos);
  RadianceOptions options;  // 3 coarse ones, 3 on halved photos, 2 on all pixels, 1 last
  std::vector<int> epochs;
  Progress progress;
  refine_radiance(photos, mattes, opacity_of(photos, mattes), options, progress,
                  [&](const RadiancePreview& preview) {
                    EXPECT_EQ(preview.planned, 9);
                    epochs.push_back(preview.epoch);
                    return true;
                  });
  EXPECT_EQ(epochs, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(RefineRadiance, StoppedByItsWatcherGivesWhatStopAfterGives) {
  const BallScene scene = two_colours();
  const Photos photos = ring_photos(scene, 6);
  const Mattes mattes = mattes_of(scene, photos);
  const OpacityTree opacity = opacity_of(photos, mattes);
  Progress progress;
  for (const int stop : {2, 3, 4}) {  // within the first stretch, at its end, within the next
    RadianceOptions options;
    const RadianceVolume told =
        refine_radiance(photos, mattes, opacity, options, progress,
                        [&](const RadiancePreview& preview) { return preview.epoch < stop; });
    options.stop_after = stop;
    const RadianceVolume asked = refine_radiance(photos, mattes, opacity, options, progress);
    EXPECT_EQ(told.grid.cells(), asked.grid.cells());
    EXPECT_EQ(told.extinction, asked.extinction);  // to the bit
    EXPECT_EQ(told.colour, asked.colour);
    EXPECT_EQ(told.grid.level(), opacity.level() + (stop <= 3 ? 0 : 1));
  }
}

TEST(RefineRadiance, NamesTheRemedyWhenNothingIsOpaque) {
  const BallScene scene = two_colours();
  const Photos photos = ring_photos(scene, 4);
  const Mattes mattes = mattes_of(scene, photos);
  OpacityTree opacity = opacity_of(photos, mattes);
  opacity.extinction.assign(opacity.extinction.size(), 0.0f);
  Progress progress;
  EXPECT_THROW(refine_radiance(photos, mattes, opacity, {}, progress), Error);
}

TEST(Subset, KeepsTheNamedCellsWithTheirValues) {
  const RadianceVolume volume{glm::dvec3(1.0),
                              2.0,
                              SparseGrid(3, {{0, 0, 0}, {1, 2, 3}, {7, 7, 7}}),
                              0,
                              {0.1f, 0.2f, 0.3f},
                              {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  const RadianceVolume part = subset(volume, {0, 2}, Progress{});
  EXPECT_EQ(part.extinction, (std::vector<float>{0.1f, 0.3f}));
  EXPECT_EQ(part.colour, (std::vector<float>{1, 2, 3, 7, 8, 9}));
  EXPECT_EQ(part.grid.find(7, 7, 7), 1);
  EXPECT_EQ(part.grid.find(1, 2, 3), SparseGrid::kAbsent);
}

TEST(RadianceVolume, ComesBackFromItsBytesAndRefusesDamagedOnes) {
  RadianceVolume volume{glm::dvec3(1.0),
                        2.0,
                        SparseGrid(3, {{0, 0, 0}, {1, 2, 3}}),
                        1,
                        {0.1f, 0.2f},
                        std::vector<float>(24, 0.5f)};
  BinaryWriter writer;
  write(writer, volume);
  BinaryReader reader(writer.bytes());
  const RadianceVolume copy = read_radiance_volume(reader);
  EXPECT_EQ(copy.origin, volume.origin);
  EXPECT_EQ(copy.degree, 1);
  EXPECT_EQ(copy.grid.cells(), volume.grid.cells());
  EXPECT_EQ(copy.extinction, volume.extinction);
  EXPECT_EQ(copy.colour, volume.colour);
  for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
    BinaryReader cut(std::span(writer.bytes()).first(size));
    EXPECT_THROW(read_radiance_volume(cut), Error) << size << " bytes";
  }
  for (const int degree : {-1, 0, 3}) {  // out of range, or not that of the colours
    volume.degree = degree;
    BinaryWriter wrong;
    write(wrong, volume);
    BinaryReader inconsistent(wrong.bytes());
    EXPECT_THROW(read_radiance_volume(inconsistent), Error) << "degree " << degree;
  }
}

}  // namespace
}  // namespace bosk
