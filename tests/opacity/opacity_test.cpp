#include "core/opacity/opacity.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <string>

#include "ball_scene.h"
#include "core/base/error.h"
#include "core/opacity/ray_cache.h"

namespace bosk {
namespace {

OpacityOptions quick() {
  OpacityOptions options;
  options.finest_level = 5;
  options.passes = 3;
  return options;
}

// Mean |alpha - matte| over all rays of the photos, composed anew.
double mean_alpha_error(const OpacityTree& tree, const Photos& photos, const Mattes& mattes) {
  Progress progress;
  const TrilinearSupport support(tree.grid);
  const RayCache cache =
      cache_rays(photos, mattes, 1, {tree.origin, tree.size_m}, tree.level(), support, progress);
  std::vector<float> extinction = tree.extinction;
  extinction.push_back(0.0f);
  double error = 0.0;
  for (const CachedRay& ray : cache.rays) {
    float depth = 0.0f;
    for_each_sample(cache, ray, support, [&](std::int32_t number, const glm::vec3& fraction) {
      float weights[8];
      trilinear_weights(fraction, weights);
      for (int i = 0; i < 8; ++i) {
        depth += weights[i] * extinction[std::size_t(support.corners(number).number[i])];
      }
      return true;
    });
    error += std::abs(1.0 - std::exp(-double(depth)) - double(ray.target.a));
  }
  return error / double(cache.rays.size());
}

std::string refusal(const Photos& photos, const Mattes& mattes) {
  Progress progress;
  try {
    estimate_opacity(photos, mattes, quick(), progress);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(EstimateOpacity, RecoversABallOfHaze) {
  BallScene scene;
  scene.extinction = 0.8;  // alpha 0.8 through the middle
  const Photos photos = ring_photos(scene, 8);
  const Mattes mattes = mattes_of(scene, photos);
  Progress progress;
  const OpacityTree tree = estimate_opacity(photos, mattes, quick(), progress);
  // A cell of 8 cm is 1.7 px: half a cell's blur at the rim, and the sampling noise inside.
  EXPECT_LT(mean_alpha_error(tree, photos, mattes), 0.03);
}

TEST(EstimateOpacity, FitsViewsThatItDidNotSee) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 12);
  Progress progress;
  const OpacityTree tree = estimate_opacity(photos, mattes_of(scene, photos), quick(), progress);
  Photos unseen{photos[0]};
  unseen[0].camera = camera_at(ring_place(scene, 0.7, 0.0), scene.centre());
  // The rim of the hull between the views, about a cell of 1.7 px around a ball 44 px across.
  EXPECT_LT(mean_alpha_error(tree, unseen, mattes_of(scene, unseen)), 0.06);
}

TEST(EstimateOpacity, TellsItsWatcherOfEachPass) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  int passes = 0;
  Progress progress;
  estimate_opacity(photos, mattes_of(scene, photos), quick(), progress,
                   [&](const OpacityPreview& preview) {
                     EXPECT_EQ(preview.iteration, ++passes);
                     EXPECT_EQ(preview.tree.extinction.size(), preview.tree.grid.size());
                     return true;
                   });
  EXPECT_GE(passes, 1);
}

TEST(EstimateOpacity, StoppedByItsWatcherGivesWhatStopAfterGives) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  const Mattes mattes = mattes_of(scene, photos);
  OpacityOptions options = quick();
  options.finest_level = 6;
  options.passes = 2;
  Progress progress;
  for (int stop = 1; stop <= 3; ++stop) {  // within the first level, at its end, within the second
    const OpacityTree told =
        estimate_opacity(photos, mattes, options, progress, [&](const OpacityPreview& preview) {
          EXPECT_EQ(preview.planned, 4);  // 2 passes at each of levels 5 and 6
          return preview.iteration < stop;
        });
    OpacityOptions fewer = options;
    fewer.stop_after = stop;
    const OpacityTree asked = estimate_opacity(photos, mattes, fewer, progress);
    EXPECT_EQ(told.grid.cells(), asked.grid.cells());
    EXPECT_EQ(told.extinction, asked.extinction);  // to the bit
    EXPECT_EQ(told.level(), stop <= 2 ? 5 : 6);
  }
}

TEST(EstimateOpacity, GivesTheSameWithOneThreadAndMany) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  const Mattes mattes = mattes_of(scene, photos);
  Progress progress;
  const OpacityTree many = estimate_opacity(photos, mattes, quick(), progress);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const OpacityTree single = estimate_opacity(photos, mattes, quick(), progress);
  EXPECT_EQ(many.grid.cells(), single.grid.cells());
  EXPECT_EQ(many.extinction, single.extinction);  // to the bit
}

TEST(EstimateOpacity, GrowsCellsUntilThereAreAboutAsManyAsAllowed) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 8);
  const Mattes mattes = mattes_of(scene, photos);
  OpacityOptions options;
  options.cell_px = 1.0;
  Progress progress;
  const std::size_t all = estimate_opacity(photos, mattes, options, progress).grid.size();
  options.max_cells = 10.0;
  const std::size_t some = estimate_opacity(photos, mattes, options, progress).grid.size();
  ASSERT_GT(all, 20'000u);
  // "About": the count grows with a power of the edge, taken from two coarser levels, in which the
  // hull's rim of one cell weighs more.
  EXPECT_GT(some, 7'000u);
  EXPECT_LT(some, 13'000u);
  options.max_cells = 1e-3 * double(2 * all);  // more than there are: no limit
  EXPECT_EQ(estimate_opacity(photos, mattes, options, progress).grid.size(), all);
}

TEST(EstimateOpacity, StopsWhenCancelled) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(estimate_opacity(photos, mattes_of(scene, photos), quick(), progress), Cancelled);
}

TEST(EstimateOpacity, StopsWhenCancelledBetweenPasses) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  Progress progress;
  const auto cancel = [&](const OpacityPreview&) {
    progress.cancel();
    return true;
  };
  EXPECT_THROW(estimate_opacity(photos, mattes_of(scene, photos), quick(), progress, cancel),
               Cancelled);
}

TEST(EstimateOpacity, RefusesASinglePhoto) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 1);
  EXPECT_NE(refusal(photos, mattes_of(scene, photos)).find("at least 2 photos"), std::string::npos);
}

TEST(EstimateOpacity, NamesThePhotoWhoseMatteIsClear) {
  const BallScene scene;
  const Photos photos = ring_photos(scene, 6);
  Mattes mattes = mattes_of(scene, photos);
  mattes[4].rgba = Image<glm::vec4>(BallScene::kSize, BallScene::kSize);
  EXPECT_NE(refusal(photos, mattes).find("ring4"), std::string::npos);
}

TEST(OpacityTree, ComesBackFromItsBytesAndRefusesDamagedOnes) {
  OpacityTree tree;
  tree.origin = {1.0, 2.0, 3.0};
  tree.size_m = 4.0;
  tree.grid = SparseGrid(3, {{1, 2, 3}, {7, 7, 7}});
  tree.extinction = {0.5f, 0.25f};
  BinaryWriter writer;
  write(writer, tree);
  BinaryReader reader(writer.bytes());
  const OpacityTree copy = read_opacity_tree(reader);
  EXPECT_EQ(copy.origin, tree.origin);
  EXPECT_EQ(copy.size_m, tree.size_m);
  EXPECT_EQ(copy.grid.cells(), tree.grid.cells());
  EXPECT_EQ(copy.extinction, tree.extinction);
  for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
    BinaryReader cut(std::span(writer.bytes()).first(size));
    EXPECT_THROW(read_opacity_tree(cut), Error) << size << " bytes";
  }
  tree.extinction.push_back(0.1f);  // one more than there are cells
  BinaryWriter wrong;
  write(wrong, tree);
  BinaryReader inconsistent(wrong.bytes());
  EXPECT_THROW(read_opacity_tree(inconsistent), Error);
}

}  // namespace
}  // namespace bosk
