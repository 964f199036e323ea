#include "core/radiance/volume_snapshot.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/opacity/ray_cache.h"
#include "core/radiance/volume_march.h"

namespace bosk {
namespace {

// Cells all over a cube of 32 a side, at its edges and at those of bricks too.
RadianceVolume scattered_volume(int degree) {
  Random random(7);
  std::vector<glm::ivec3> cells{{0, 0, 0}, {31, 31, 31}, {8, 8, 8}, {7, 8, 15}, {16, 0, 31}};
  for (int i = 0; i < 3000; ++i) {
    cells.emplace_back(int(random.below(32)), int(random.below(32)), int(random.below(32)));
  }
  RadianceVolume volume{glm::dvec3(1.0), 2.0, SparseGrid(5, cells), degree, {}, {}};
  const std::size_t stride = std::size_t(volume.coefficients()) * 3;
  for (std::size_t i = 0; i < volume.grid.size(); ++i) {
    volume.extinction.push_back(0.01f * float(random.below(500)));
    for (std::size_t k = 0; k < stride; ++k) {
      volume.colour.push_back(k < 3 ? float(random.below(256)) / 255.0f : 9.0f);
    }
  }
  return volume;
}

// Colour times extinction, and extinction, by the definition.
glm::vec4 interpolated(const RadianceVolume& volume, const glm::vec3& at) {
  const glm::vec3 base = glm::floor(at);
  float weights[8];
  trilinear_weights(at - base, weights);
  glm::vec4 sum(0.0f);
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 c = glm::ivec3(base) + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
    const std::int32_t number = volume.grid.find(c.x, c.y, c.z);
    if (number < 0) continue;
    const auto cell = std::size_t(number);
    const float* rgb = &volume.colour[cell * std::size_t(volume.coefficients()) * 3];
    sum += glm::vec4(rgb[0], rgb[1], rgb[2], 1.0f) * (weights[i] * volume.extinction[cell]);
  }
  return sum;
}

glm::vec4 sampled(const VolumeSnapshot& snapshot, const glm::vec3& at) {
  const glm::ivec3 base(glm::floor(at));
  const VolumeSnapshot::Brick* brick = brick_around(snapshot, base);
  return brick ? sample_brick(*brick, at - glm::vec3(base), base & 7) : glm::vec4(0.0f);
}

TEST(SnapshotOf, HoldsTheVolumeAtEveryPointAcrossBricksToo) {
  for (const int degree : {0, 1}) {
    const RadianceVolume volume = scattered_volume(degree);
    const VolumeSnapshot snapshot = snapshot_of(volume);
    Random random(3);
    for (int i = 0; i < 5000; ++i) {
      const glm::vec3 at =
          glm::vec3(random.below(3300), random.below(3300), random.below(3300)) * 0.01f - 1.0f;
      const glm::vec4 truth = interpolated(volume, at), found = sampled(snapshot, at);
      // Colours are multiples of 1/255, so only rounding of single precision is left.
      for (int c = 0; c < 4; ++c) EXPECT_NEAR(found[c], truth[c], 1e-4f);
    }
  }
}

TEST(SnapshotOf, MergedCellsKeepTheLightThatCrossesThem) {
  std::vector<glm::ivec3> cells;
  for (int i = 0; i < 512; ++i) cells.emplace_back(4 + i % 8, 4 + i / 8 % 8, 4 + i / 64);
  OpacityTree tree{glm::dvec3(0.0), 1.0, SparseGrid(5, cells), {}};
  tree.extinction.assign(512, 0.1f);
  const VolumeSnapshot coarser = snapshot_of(tree, 4);
  EXPECT_EQ(coarser.level, 4);
  EXPECT_NEAR(sampled(coarser, {3.0f, 3.0f, 3.0f}).w, 0.2f, 1e-6f);  // two layers of 0.1
  EXPECT_NEAR(sampled(coarser, {1.0f, 3.0f, 3.0f}).w, 0.0f, 1e-6f);
}

TEST(SnapshotOf, BoundsAreThoseOfTheCells) {
  const OpacityTree tree{
      glm::dvec3(1.0, 2.0, 3.0), 8.0, SparseGrid(3, {{1, 2, 3}, {4, 2, 5}}), {0.5f, 0.5f}};
  const VolumeSnapshot snapshot = snapshot_of(tree);
  EXPECT_EQ(snapshot.bounds.lower, glm::dvec3(2.0, 4.0, 6.0));
  EXPECT_EQ(snapshot.bounds.upper, glm::dvec3(6.0, 5.0, 9.0));
  EXPECT_FALSE(snapshot.has_colour);
}

TEST(SnapshotOf, AnEmptyVolumeIsEmptyEverywhere) {
  const VolumeSnapshot snapshot =
      snapshot_of(OpacityTree{glm::dvec3(0.0), 1.0, SparseGrid(4, {}), {}});
  EXPECT_TRUE(snapshot.bricks.empty());
  EXPECT_EQ(snapshot.bounds.upper, glm::dvec3(1.0));
}

}  // namespace
}  // namespace bosk
