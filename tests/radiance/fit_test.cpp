#include "core/radiance/fit.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "core/radiance/harmonics.h"
#include "march.h"
#include "tests/opacity/ball_scene.h"

namespace bosk {
namespace {

constexpr glm::vec3 kRed{0.8f, 0.2f, 0.1f}, kGreen{0.1f, 0.6f, 0.2f};

// A block of 4^3 cells, one half red and one green, and what 8 photos see of it.
struct Block {
  RadianceVolume truth;
  TrilinearSupport support{SparseGrid(3, {})};
  RayCache cache;
};

RadianceVolume block_volume(int degree, float extinction) {
  const BallScene scene;
  std::vector<glm::ivec3> cells;
  cells.reserve(64);
  for (int i = 0; i < 64; ++i) cells.emplace_back(2 + i % 4, 2 + i / 4 % 4, 2 + i / 16);
  RadianceVolume volume{scene.centre() - 1.2, 2.4, SparseGrid(3, cells), degree, {}, {}};
  volume.extinction.assign(64, extinction);
  const auto terms = std::size_t(volume.coefficients());
  volume.colour.assign(64 * terms * 3, 0.0f);
  return volume;
}

void set_colour(RadianceVolume& volume, std::size_t cell, std::size_t term, const glm::vec3& rgb) {
  const auto terms = std::size_t(volume.coefficients());
  for (int c = 0; c < 3; ++c) volume.colour[(cell * terms + term) * 3 + std::size_t(c)] = rgb[c];
}

// `swing`: how much the colour changes with the direction along x; needs degree 1.
Block make_block(int degree, float swing) {
  Block block;
  block.truth = block_volume(degree, 0.4f);
  for (std::size_t i = 0; i < 64; ++i) {
    set_colour(block.truth, i, 0, block.truth.grid.cells()[i].x < 4 ? kRed : kGreen);
    if (degree > 0) set_colour(block.truth, i, 1, glm::vec3(swing));
  }
  const BallScene scene;
  const Photos photos = ring_photos(scene, 8);
  Progress progress;
  block.support = TrilinearSupport(block.truth.grid);
  block.cache = cache_rays(photos, mattes_of(scene, photos), 1,
                           {block.truth.origin, block.truth.size_m}, 3, block.support, progress);
  for (CachedRay& ray : block.cache.rays) {
    ray.target = slow_march(block.truth, block.cache, ray, block.support);
  }
  return block;
}

RadianceVolume grey_start(int degree) {
  RadianceVolume volume = block_volume(degree, 0.15f);
  for (std::size_t i = 0; i < 64; ++i) set_colour(volume, i, 0, glm::vec3(0.4f));
  return volume;
}

FitSchedule schedule(int epochs) {
  FitSchedule result;
  result.epochs = epochs;
  result.harmonics_decay = 0.0f;  // the truth has no prior
  return result;
}

RadianceVolume fitted(const Block& block, int degree, int epochs) {
  RadianceVolume volume = grey_start(degree);
  Progress progress;
  fit_volume(volume, block.cache, block.support, schedule(epochs), progress, {});
  return volume;
}

TEST(FitVolume, RecoversTheVolumeFromItsOwnRendersAtEveryDegree) {
  for (const int degree : {0, 1, 2}) {
    const Block block = make_block(0, 0.0f);
    const RadianceVolume volume = fitted(block, degree, 8);
    const MarchError error = march_error(volume, block.cache, block.support);
    // 192 steps of at most 0.1 reach anything in range; the last ones, a twentieth of the first,
    // leave noise of about 0.003.
    EXPECT_LT(error.colour, 0.01) << "degree " << degree;
    EXPECT_LT(error.alpha, 0.01) << "degree " << degree;
  }
}

TEST(FitVolume, RecoversEachCellsColourAndExtinction) {
  const Block block = make_block(0, 0.0f);
  const RadianceVolume volume = fitted(block, 0, 12);
  double extinction = 0.0, colour = 0.0;
  for (std::size_t i = 0; i < 64; ++i) {
    extinction += std::abs(double(volume.extinction[i]) - 0.4) / 64.0;
    for (std::size_t c = 0; c < 3; ++c) {
      colour += std::abs(double(volume.colour[3 * i + c] - block.truth.colour[3 * i + c])) / 192.0;
    }
  }
  EXPECT_LT(extinction, 0.04);  // a tenth of the truth: cells behind each other trade a little
  EXPECT_LT(colour, 0.04);
}

TEST(FitVolume, FollowsColoursThatTurnWithTheViewOnlyFromDegreeOneOn) {
  const Block block = make_block(1, 0.1f);
  const double flat = march_error(fitted(block, 0, 8), block.cache, block.support).colour;
  const double turning = march_error(fitted(block, 1, 8), block.cache, block.support).colour;
  EXPECT_LT(turning, 0.5 * flat);
  EXPECT_LT(turning, 0.01);  // as above
}

TEST(FitVolume, StaysAtTheTruthWhenStartedThere) {
  const Block block = make_block(0, 0.0f);
  RadianceVolume volume = block.truth;
  Progress progress;
  fit_volume(volume, block.cache, block.support, schedule(8), progress, {});
  const MarchError error = march_error(volume, block.cache, block.support);
  // Adam scales rounding errors up to whole steps, of 0.06 in colour at first; over 8 passes they
  // must not add up but settle as the steps shrink.
  EXPECT_LT(error.colour, 0.002);
  EXPECT_LT(error.alpha, 0.002);
}

TEST(FitVolume, GivesTheSameWithOneThreadAndMany) {
  const Block block = make_block(0, 0.0f);
  const RadianceVolume many = fitted(block, 1, 2);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const RadianceVolume single = fitted(block, 1, 2);
  EXPECT_EQ(many.extinction, single.extinction);  // to the bit
  EXPECT_EQ(many.colour, single.colour);
}

TEST(FitVolume, ReportsRisingPsnr) {
  const Block block = make_block(0, 0.0f);
  RadianceVolume volume = grey_start(0);
  std::vector<double> psnr_db;
  Progress progress;
  fit_volume(volume, block.cache, block.support, schedule(4), progress, [&](double value) {
    psnr_db.push_back(value);
    return true;
  });
  ASSERT_EQ(psnr_db.size(), 4u);
  EXPECT_GT(psnr_db.back(), psnr_db.front());
}

TEST(FitVolume, LeavesTheVolumeAloneWithoutRays) {
  Block block = make_block(0, 0.0f);
  block.cache.rays.clear();
  block.cache.first_rays = {0};
  RadianceVolume volume = grey_start(0);
  Progress progress;
  fit_volume(volume, block.cache, block.support, schedule(1), progress, [](double psnr_db) {
    EXPECT_TRUE(std::isfinite(psnr_db));
    return true;
  });
  EXPECT_EQ(volume.extinction, grey_start(0).extinction);
  EXPECT_EQ(volume.colour, grey_start(0).colour);
}

TEST(FitVolume, PullsNeighboursTogetherByTotalVariation) {
  const auto roughness = [](double weight) {
    const Block block = make_block(0, 0.0f);
    RadianceVolume volume = grey_start(0);
    FitSchedule smooth = schedule(4);
    smooth.colour_variation = weight;
    Progress progress;
    fit_volume(volume, block.cache, block.support, smooth, progress, {});
    double sum = 0.0;
    for (std::size_t i = 0; i < 64; ++i) {
      const glm::ivec3 cell(volume.grid.cells()[i]);
      const std::int32_t next = volume.grid.find(cell.x + 1, cell.y, cell.z);
      if (next < 0) continue;
      sum += std::abs(double(volume.colour[3 * i] - volume.colour[3 * std::size_t(next)]));
    }
    return sum;
  };
  EXPECT_LT(roughness(30.0), 0.5 * roughness(0.0));
}

TEST(FitVolume, StopsWhenCancelled) {
  const Block block = make_block(0, 0.0f);
  RadianceVolume volume = grey_start(0);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(fit_volume(volume, block.cache, block.support, schedule(1), progress, {}),
               Cancelled);
}

TEST(BackProjectColour, GivesSeenCellsTheOneColourOfThePhotos) {
  Block block = make_block(0, 0.0f);
  for (CachedRay& ray : block.cache.rays) ray.target = glm::vec4(kGreen * 0.5f, 0.5f);
  RadianceVolume volume = grey_start(1);
  Progress progress;
  back_project_colour(volume, block.cache, block.support, progress);
  for (std::size_t i = 0; i < 64; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(volume.colour[i * 12 + c], kGreen[int(c)], 1e-4f);  // sums of floats
      EXPECT_EQ(volume.colour[i * 12 + 3 + c], 0.0f);
    }
  }
}

TEST(BackProjectColour, PaintsCellsGreyThatNoPhotoSees) {
  Block block = make_block(0, 0.0f);
  for (CachedRay& ray : block.cache.rays) ray.target = glm::vec4(0.0f);
  RadianceVolume volume = grey_start(0);
  Progress progress;
  back_project_colour(volume, block.cache, block.support, progress);
  for (const float value : volume.colour) EXPECT_NEAR(value, 0.4f, 1e-6f);
}

TEST(CellVisibility, IsEachCellsShareOfAStraightRay) {
  RadianceVolume volume{glm::dvec3(0.0),
                        1.0,
                        SparseGrid(3, {{2, 4, 4}, {3, 4, 4}}),
                        0,
                        {0.7f, 0.5f},
                        std::vector<float>(6, 0.5f)};
  const TrilinearSupport support(volume.grid);
  CachedRay ray;
  ray.direction = {1.0f, 0.0f, 0.0f};
  ray.first_sample = 1.0f;
  ray.span_count = 1;
  RayCache cache{{ray}, {{0, 8}}, {{-1.0f, 4.0f, 4.0f}}, {0, 1}};
  Progress progress;
  const std::vector<float> visibility = cell_visibility(volume, cache, support, progress);
  EXPECT_NEAR(visibility[0], 1.0f - std::exp(-0.7f), 1e-6f);
  EXPECT_NEAR(visibility[1], std::exp(-0.7f) * (1.0f - std::exp(-0.5f)), 1e-6f);
}

TEST(Harmonics, AreOrthonormalInTheMeanOverTheSphere) {
  constexpr int kDirections = 4000;
  double products[9][9] = {};
  for (int i = 0; i < kDirections; ++i) {  // golden-angle spiral: equal areas
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections, across = std::sqrt(1.0 - z * z);
    const auto basis =
        harmonics({across * std::cos(2.399963 * i), across * std::sin(2.399963 * i), z});
    for (std::size_t j = 0; j < 9; ++j) {
      for (std::size_t k = 0; k < 9; ++k) {
        products[j][k] += double(basis[j]) * double(basis[k]) / kDirections;
      }
    }
  }
  for (int j = 0; j < 9; ++j) {
    for (int k = 0; k < 9; ++k) {
      EXPECT_NEAR(products[j][k], j == k ? 1.0 : 0.0, 2e-3);  // the spiral's own evenness
    }
  }
}

}  // namespace
}  // namespace bosk
