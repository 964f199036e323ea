#include "core/billboard/billboard.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/billboard/bake.h"
#include "core/billboard/coarser.h"
#include "core/billboard/morton.h"
#include "core/billboard/view_choice.h"
#include "core/billboard/visibility.h"

namespace bosk {
namespace {

constexpr glm::vec3 kColour{0.2f, 0.6f, 0.4f};

// A solid block of cells of one colour and extinction (per cell edge), lower .. upper - 1.
RadianceVolume solid(int level, int lower, int upper, float extinction) {
  std::vector<glm::ivec3> cells;
  for (int z = lower; z < upper; ++z) {
    for (int y = lower; y < upper; ++y) {
      for (int x = lower; x < upper; ++x) cells.emplace_back(x, y, z);
    }
  }
  RadianceVolume volume{glm::dvec3(-1.0), 2.0, SparseGrid(level, cells), 0, {}, {}};
  volume.extinction.assign(cells.size(), extinction);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (int c = 0; c < 3; ++c) volume.colour.push_back(kColour[c]);
  }
  return volume;
}

std::vector<Camera> cameras_at(const std::vector<glm::dvec3>& places) {
  std::vector<Camera> cameras(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    cameras[i].camera_from_world.translation = -places[i];
  }
  return cameras;
}

const std::vector<Camera> kCameras = cameras_at({{8, 0, 0}, {0, 9, 0}, {-10, 0, 0}});

Billboards baked(const RadianceVolume& volume, const BillboardOptions& options) {
  Progress progress;
  return bake_billboards(volume, kCameras, options, progress);
}

TEST(Morton, ComesBackFromItsCode) {
  for (const glm::ivec3& cell : {glm::ivec3(0), glm::ivec3(1, 2, 4), glm::ivec3(511, 0, 300),
                                 glm::ivec3(0x1fffff, 0x12345, 0x1fffff)}) {
    EXPECT_EQ(cell_from_morton(morton_from_cell(cell)), cell);
  }
}

TEST(Morton, HasTheLowestBitFromXAndParentsByShifting) {
  EXPECT_EQ(morton_from_cell({1, 0, 0}), 1u);
  EXPECT_EQ(morton_from_cell({0, 1, 0}), 2u);
  EXPECT_EQ(morton_from_cell({0, 0, 1}), 4u);
  EXPECT_EQ(morton_from_cell({13, 6, 255}) >> 3, morton_from_cell({6, 3, 127}));
}

TEST(HemisphereViews, StandAtTheMedianDistanceAndNotBelowTheLowestElevation) {
  const Box crown{glm::dvec3(-1.0), glm::dvec3(1.0)};
  const std::vector<glm::dvec3> views = hemisphere_views(kCameras, crown, 12);
  ASSERT_EQ(views.size(), 12u);
  for (const glm::dvec3& view : views) {
    EXPECT_NEAR(glm::length(view), 9.0, 1e-9);  // the median of 8, 9, 10
    EXPECT_GE(view.z / 9.0, -0.05);
  }
}

TEST(HemisphereViews, LeaveNoDirectionFarFromAView) {
  const Box crown{glm::dvec3(-1.0), glm::dvec3(1.0)};
  const std::vector<glm::dvec3> views = hemisphere_views(kCameras, crown, 12);
  for (int i = 0; i < 500; ++i) {
    const double z = (i + 0.5) / 500.0, across = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(across * std::cos(2.4 * i), across * std::sin(2.4 * i), z);
    double nearest = -1.0;
    for (const glm::dvec3& view : views) {
      nearest = std::max(nearest, glm::dot(view, direction) / 9.0);
    }
    // 12 caps that just cover half the sphere evenly reach some 33 degrees; a spiral's edge more.
    EXPECT_GT(nearest, std::cos(0.85));
  }
}

TEST(BakeKernels, GivesEachTexelTheTentsMeanDepth) {
  const float extinction = 1.3f;
  const RadianceVolume volume = solid(3, 3, 5, extinction);
  BillboardLevel level;
  level.level = 3;
  level.views = {0};
  Progress progress;
  bake_kernels(volume, {{9, 0, 0}}, level, progress);
  ASSERT_EQ(level.cells.size(), 8u);
  EXPECT_TRUE(std::is_sorted(level.cells.begin(), level.cells.end()));
  EXPECT_EQ(level.side_factor, 2.0f);
  const float tent[4] = {0.25f, 0.75f, 0.75f, 0.25f};  // means of 1 - |x| over quarters of -1 .. 1
  for (std::size_t i = 0; i < level.texture.size(); ++i) {
    const float alpha = 1.0f - std::exp(-extinction * tent[i % 16 / 4] * tent[i % 4]);
    EXPECT_NEAR(float(level.texture[i].a), 255.0f * alpha, 0.51f);  // rounding to 8 bits
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(float(level.texture[i][c]), 255.0f * kColour[c], 0.51f);
    }
  }
}

TEST(BakeCubes, GivesAUniformCubeItsClosedFormAlpha) {
  const float extinction = 0.15f;
  const RadianceVolume volume = solid(4, 2, 14, extinction);
  BillboardLevel level;
  level.level = 2;
  level.side_factor = 1.5f;
  level.views = {0};
  level.cells = {morton_from_cell({1, 1, 1})};  // cells 4 to 7 of the finest, inside the block
  Progress progress;
  const glm::dvec3 centre = volume.origin + 1.5 * 0.5;
  bake_cubes(volume, VolumeSampler(volume), {centre + glm::dvec3(10, 0, 0)}, level, progress);
  ASSERT_EQ(level.texture.size(), 16u);
  const float whole = 255.0f * (1.0f - std::exp(-4.0f * extinction));  // four cells deep
  for (const std::size_t texel : {5u, 6u, 9u, 10u}) {                  // wholly inside the cube
    EXPECT_NEAR(float(level.texture[texel].a), whole, 2.0f);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(float(level.texture[texel][c]), 255.0f * kColour[c], 1.0f);
    }
  }
  // The border texels reach from 0.75 to 0.375 edges off centre; one of two rays meets the cube.
  EXPECT_NEAR(float(level.texture[4].a), 0.5f * whole, 2.0f);
  EXPECT_NEAR(float(level.texture[0].a), 0.25f * whole, 2.0f);
}

TEST(TransmittanceToViews, FallsWithTheDepthInFrontOfACell) {
  const RadianceVolume volume = solid(4, 2, 14, 0.3f);  // 12 cells a side
  const std::vector<std::uint64_t> cells{morton_from_cell({13, 8, 8}), morton_from_cell({8, 8, 8}),
                                         morton_from_cell({2, 8, 8})};
  Progress progress;
  // The view is level with the cells' centres.
  const std::vector<float> reach =
      transmittance_to_views(volume, 4, cells, {{9.0, 0.0625, 0.0625}}, progress);
  ASSERT_EQ(reach.size(), 3u);
  EXPECT_FLOAT_EQ(reach[0], 1.0f);
  // Samples at 1.5, 2.5, ... cells in front of the centre of cell 8 fall on the walls between
  // cells: 9|10 to 12|13 inside, 13|14 in either, so 4 or 5 cells of 0.3.
  EXPECT_LE(reach[1], std::exp(-4 * 0.3f) + 1e-4f);
  EXPECT_GE(reach[1], std::exp(-5 * 0.3f) - 1e-4f);
  EXPECT_LE(reach[2], std::exp(-10 * 0.3f) + 1e-4f);
}

TEST(BakeBillboards, MakesLevelsFromCoarsestToFinest) {
  BillboardOptions options;
  options.coarsest_level = 2;
  options.views = 5;
  options.texels = 8;
  const Billboards billboards = baked(solid(4, 5, 11, 0.4f), options);
  ASSERT_EQ(billboards.levels.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const BillboardLevel& level = billboards.levels[i];
    EXPECT_EQ(level.level, 2 + int(i));
    EXPECT_EQ(level.views.size(), i < 1 ? 5u : 1u);  // one view serves all at the finest two
    EXPECT_EQ(level.texels, i < 1 ? 8 : 4);
    EXPECT_TRUE(std::is_sorted(level.cells.begin(), level.cells.end()));
    EXPECT_EQ(level.texture.size(), level.cells.size() * level.views.size() * level.texture_size());
  }
  EXPECT_EQ(billboards.levels.back().cells.size(), 216u);
}

TEST(BakeBillboards, KeepsAllViewsAtTheFinestLevelOfViewDependentColour) {
  RadianceVolume volume = solid(4, 7, 9, 0.4f);
  volume.degree = 1;
  volume.colour.assign(volume.grid.size() * 12, 0.1f);
  EXPECT_EQ(baked(volume, {}).levels.back().views.size(), 12u);
}

// Billboards of the finest cubes (level below the finest) that show anything.
std::size_t shown(const Billboards& billboards) {
  const BillboardLevel& level = billboards.levels[billboards.levels.size() - 2];
  std::size_t count = 0;
  for (std::size_t first = 0; first < level.texture.size(); first += level.texture_size()) {
    const auto begin = level.texture.begin() + std::ptrdiff_t(first);
    const auto end = begin + std::ptrdiff_t(level.texture_size());
    count += std::any_of(begin, end, [](const glm::u8vec4& t) { return t.a > 0; }) ? 1u : 0u;
  }
  return count;
}

TEST(BakeBillboards, ClearsViewsThatTheCrownHides) {
  BillboardOptions all, pruned;
  all.prune = 0.0;
  pruned.prune = 0.01;
  const RadianceVolume dense = solid(4, 2, 14, 1.5f), airy = solid(4, 2, 14, 0.05f);
  all.kernel_levels = pruned.kernel_levels = 1;
  all.coarsest_level = pruned.coarsest_level = 3;
  EXPECT_LT(shown(baked(dense, pruned)), shown(baked(dense, all)));
  EXPECT_EQ(shown(baked(airy, pruned)), shown(baked(airy, all)));
}

TEST(CoarserVolume, LetsAsMuchLightThroughAsItsChildren) {
  // A full block: two layers of 0.4. One child alone: a quarter of the columns along each axis
  EXPECT_NEAR(coarser_volume(solid(3, 2, 4, 0.4f)).extinction.at(0), 0.8f, 1e-5f);
  const RadianceVolume corner = coarser_volume(solid(3, 2, 3, 2.0f));
  ASSERT_EQ(corner.grid.size(), 1u);
  EXPECT_NEAR(std::exp(-corner.extinction[0]), 0.75f + 0.25f * std::exp(-2.0f), 1e-5f);
}

TEST(CoarserVolume, WeighsColoursByExtinction) {
  RadianceVolume volume = solid(3, 2, 4, 0.0f);
  volume.extinction[0] = 3.0f, volume.extinction[7] = 1.0f;
  for (std::size_t k = 0; k < 3; ++k) volume.colour[k] = 1.0f, volume.colour[21 + k] = 0.2f;
  EXPECT_NEAR(coarser_volume(volume).colour[0], (3.0f * 1.0f + 1.0f * 0.2f) / 4.0f, 1e-5f);
}

TEST(CoarserVolume, KeepsAnOpaqueBlockFinite) {
  const RadianceVolume coarser = coarser_volume(solid(3, 2, 4, 20.0f));
  EXPECT_TRUE(std::isfinite(coarser.extinction[0]));
  EXPECT_GT(coarser.extinction[0], 15.0f);
}

TEST(BakeBillboards, DropsFinestCellsHiddenFromEverywhere) {
  BillboardOptions options;
  options.views = 12;
  const Billboards dense = baked(solid(5, 2, 30, 2.0f), options);
  EXPECT_LT(dense.levels.back().cells.size(), std::size_t(28 * 28 * 28));
  EXPECT_GT(dense.levels.back().cells.size(), std::size_t(28 * 28));  // at least the top stays
}

TEST(BakeBillboards, RefusesAnEmptyVolume) {
  RadianceVolume empty;
  empty.degree = 0;
  Progress progress;
  EXPECT_THROW(bake_billboards(empty, kCameras, {}, progress), Error);
}

TEST(BakeBillboards, GivesTheSameWithOneThreadAndMany) {
  const RadianceVolume volume = solid(4, 5, 11, 0.4f);
  BinaryWriter many, single;
  write(many, baked(volume, {}));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  write(single, baked(volume, {}));
  EXPECT_EQ(many.bytes(), single.bytes());
}

TEST(BakeBillboards, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(bake_billboards(solid(4, 5, 11, 0.4f), kCameras, {}, progress), Cancelled);
}

TEST(Billboards, ComeBackFromTheirBytesAndRefuseDamagedOnes) {
  Billboards billboards{glm::dvec3(1.0), 3.0, {{1, 2, 3}}, {}};
  BillboardLevel level;
  level.level = 4;
  level.views = {0};
  level.cells = {5, 9};
  level.texture.assign(32, glm::u8vec4(1, 2, 3, 4));
  billboards.levels = {level};
  BinaryWriter writer;
  write(writer, billboards);
  BinaryReader reader(writer.bytes());
  const Billboards copy = read_billboards(reader);
  EXPECT_TRUE(reader.at_end());
  ASSERT_EQ(copy.levels.size(), 1u);
  EXPECT_EQ(copy.view_positions, billboards.view_positions);
  EXPECT_EQ(copy.levels[0].cells, level.cells);
  EXPECT_EQ(copy.levels[0].texture, level.texture);
  for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
    BinaryReader cut(std::span(writer.bytes()).first(size));
    EXPECT_THROW(read_billboards(cut), Error) << size << " bytes";
  }
  billboards.levels[0].texture.pop_back();
  BinaryWriter wrong;
  write(wrong, billboards);
  BinaryReader inconsistent(wrong.bytes());
  EXPECT_THROW(read_billboards(inconsistent), Error);
}

}  // namespace
}  // namespace bosk
