#include "core/opacity/sparse_grid.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/opacity/ray_cache.h"
#include "core/opacity/resample.h"

namespace bosk {
namespace {

// Every seventh cell of an 8^3 grid, last first and each twice.
std::vector<glm::ivec3> scattered_cells() {
  std::vector<glm::ivec3> cells;
  for (int i = 511; i >= 0; i -= 7) {
    for (int repeat = 0; repeat < 2; ++repeat) cells.emplace_back(i % 8, i / 8 % 8, i / 64);
  }
  return cells;
}

TEST(SparseGrid, NumbersEachCellOnceInTheOrderOfItsList) {
  const SparseGrid grid(3, scattered_cells());
  ASSERT_EQ(grid.size(), 74u);  // 512 / 7, rounded up
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const glm::ivec3 cell(grid.cells()[i]);
    EXPECT_EQ(grid.find(cell.x, cell.y, cell.z), std::int32_t(i));
  }
}

TEST(SparseGrid, HoldsNoOtherCells) {
  const SparseGrid grid(3, scattered_cells());
  std::size_t found = 0;
  for (int z = -1; z <= 8; ++z) {
    for (int y = -1; y <= 8; ++y) {
      for (int x = -1; x <= 8; ++x) found += grid.find(x, y, z) == SparseGrid::kAbsent ? 0u : 1u;
    }
  }
  EXPECT_EQ(found, grid.size());
}

TEST(SparseGrid, NamesTheLargestEmptyBlockAroundAPlace) {
  const SparseGrid grid(5, {{1, 2, 3}, {17, 0, 0}});
  EXPECT_EQ(grid.empty_block(3, 3, 3), 0);     // same brick of 4 as (1, 2, 3)
  EXPECT_EQ(grid.empty_block(4, 2, 3), 4);     // next brick, same block of 16
  EXPECT_EQ(grid.empty_block(16, 4, 0), 4);    // beside (17, 0, 0)'s brick
  EXPECT_EQ(grid.empty_block(16, 16, 0), 16);  // no cell in the block
}

TEST(SparseGrid, ComesBackFromItsBytes) {
  const SparseGrid grid(3, scattered_cells());
  BinaryWriter writer;
  write(writer, grid);
  BinaryReader reader(writer.bytes());
  const SparseGrid copy = read_sparse_grid(reader);
  EXPECT_EQ(copy.level(), 3);
  EXPECT_EQ(copy.cells(), grid.cells());
  EXPECT_TRUE(reader.at_end());
}

TEST(SparseGrid, RefusesStoredCellsOutsideTheGrid) {
  BinaryWriter writer;
  writer.value(3);
  writer.array(std::vector<glm::u16vec3>{{8, 0, 0}});
  BinaryReader reader(writer.bytes());
  EXPECT_THROW(read_sparse_grid(reader), Error);
}

TEST(SparseGrid, GrowsByTheCellsAboveAsIfTheyHadBeenListed) {
  Random random(3);
  for (const int level : {2, 4, 6}) {
    std::vector<glm::ivec3> cells, listed;
    const auto side = std::uint64_t(1) << level;
    for (int i = 0; i < 300; ++i) {
      cells.emplace_back(random.below(side), random.below(side), random.below(side));
    }
    cells.emplace_back(glm::ivec3(int(side) - 1));
    for (const glm::ivec3& cell : cells) {
      for (int i = 0; i < 8; ++i) {
        listed.push_back(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2));
      }
    }
    const SparseGrid grown = SparseGrid(level, cells).grown(), expected(level + 1, listed);
    EXPECT_EQ(grown.level(), level + 1);
    ASSERT_EQ(grown.cells(), expected.cells());
    for (std::size_t i = 0; i < grown.size(); ++i) {
      const glm::ivec3 cell(grown.cells()[i]);
      ASSERT_EQ(grown.find(cell.x, cell.y, cell.z), std::int32_t(i));
    }
    for (int i = 0; i < 1000; ++i) {
      const glm::ivec3 at(random.below(2 * side), random.below(2 * side), random.below(2 * side));
      ASSERT_EQ(grown.find(at.x, at.y, at.z), expected.find(at.x, at.y, at.z));
      ASSERT_EQ(grown.empty_block(at.x, at.y, at.z), expected.empty_block(at.x, at.y, at.z));
    }
  }
  EXPECT_EQ(SparseGrid(3, {}).grown().size(), 0u);
}

TEST(TrilinearSupport, SurroundsALoneCellByEightBases) {
  const SparseGrid grid(2, {{0, 3, 1}});
  const TrilinearSupport support(grid);
  EXPECT_EQ(support.size(), 8u);
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 offset(i & 1, i >> 1 & 1, i >> 2);
    const std::int32_t number = support.find(glm::ivec3(0, 3, 1) - offset);
    ASSERT_GE(number, 0);
    for (int corner = 0; corner < 8; ++corner) {
      EXPECT_EQ(support.corners(number).number[corner], corner == i ? 0 : 1);  // 1: absent
    }
  }
  EXPECT_LT(support.find({1, 3, 1}), 0);
  EXPECT_LT(support.find({-2, 3, 1}), 0);
}

TEST(TrilinearWeights, SumToOneAndReproduceThePoint) {
  for (const glm::vec3& fraction :
       {glm::vec3(0.0f), glm::vec3(0.25f, 0.5f, 0.875f), glm::vec3(0.9f, 0.1f, 0.3f)}) {
    float weights[8], sum = 0.0f;
    trilinear_weights(fraction, weights);
    glm::vec3 place(0.0f);
    for (int i = 0; i < 8; ++i) {
      sum += weights[i];
      place += weights[i] * glm::vec3(i & 1, i >> 1 & 1, i >> 2);
    }
    EXPECT_NEAR(sum, 1.0f, 1e-6f);  // rounding of eight products
    EXPECT_NEAR(glm::distance(place, fraction), 0.0f, 1e-6f);
  }
}

TEST(RefinedExtinction, HalvesWithTheCellEdgeInsideAUniformBlock) {
  std::vector<glm::ivec3> coarse, fine{{3, 3, 3}, {4, 4, 4}};
  for (int i = 0; i < 64; ++i) coarse.emplace_back(i % 4, i / 4 % 4, i / 16);
  const SparseGrid grid(2, coarse);
  for (const float value :
       refined_extinction(grid, std::vector<float>(64, 0.8f), SparseGrid(3, fine), Progress{})) {
    EXPECT_NEAR(value, 0.4f, 1e-6f);
  }
}

TEST(RefinedMean, DoesNotPullColoursTowardsAbsentCells) {
  const SparseGrid coarse(2, {{1, 1, 1}});
  const SparseGrid fine(3, {{2, 2, 2}, {3, 3, 3}});
  for (const float value : refined_mean(coarse, {0.6f}, 1, fine, Progress{}))
    EXPECT_NEAR(value, 0.6f, 1e-6f);
}

}  // namespace
}  // namespace bosk
