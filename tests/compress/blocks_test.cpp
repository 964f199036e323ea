#include "core/compress/blocks.h"

#include <gtest/gtest.h>

#include <numeric>

#include "leafy_billboards.h"

namespace bosk {
namespace {

BillboardLevel level_of(const std::vector<BlockTexels>& blocks) {
  BillboardLevel level;
  level.views = {0};
  level.cells.resize(blocks.size());
  std::iota(level.cells.begin(), level.cells.end(), std::uint64_t(0));
  for (const BlockTexels& block : blocks) {
    level.texture.insert(level.texture.end(), block.begin(), block.end());
  }
  return level;
}

BlockTexels filled(glm::u8vec4 texel) {
  BlockTexels block;
  block.fill(texel);
  return block;
}

TEST(BlockTexels, AreCountedRowByRowInAnEightTexelTexture) {
  BillboardLevel level;
  level.texels = 8;
  level.views = {0, 1};
  level.cells = {0};
  for (int i = 0; i < 128; ++i) level.texture.emplace_back(i % 8, i / 8 % 8, i / 64, 255);
  ASSERT_EQ(block_count(level), 8u);
  for (std::size_t block = 0; block < 8; ++block) {
    const auto column = std::uint8_t(4 * (block % 2)), row = std::uint8_t(4 * (block / 2 % 2));
    const auto view = std::uint8_t(block / 4);
    const BlockTexels texels = block_texels(level, block);
    EXPECT_EQ(texels[0], glm::u8vec4(column, row, view, 255));
    EXPECT_EQ(texels[7], glm::u8vec4(column + 3, row + 1, view, 255));
  }
}

TEST(ColourBlock, GivesClearTexelsTheColourAroundThem) {
  BlockTexels texels = filled({0, 0, 0, 0});
  texels[0] = {200, 100, 50, 255};
  texels[15] = {20, 10, 5, 255};
  const ColourBlock block = colour_block(texels);
  EXPECT_EQ(block.srgb[0], glm::u8vec3(200, 100, 50));
  EXPECT_EQ(block.srgb[15], glm::u8vec3(20, 10, 5));
  EXPECT_GT(block.srgb[1].r, 190);  // nine times nearer to the bright texel, to the fourth power
  EXPECT_LT(block.srgb[14].r, 30);
}

TEST(DistinctColours, IgnoreTheColourOfClearTexels) {
  BlockTexels one = filled({10, 20, 30, 255});
  one[3] = {90, 20, 30, 128};
  one[7] = {1, 2, 3, 0};
  BlockTexels other = one;
  other[7] = {200, 200, 200, 0};
  Progress quiet;
  const auto blocks = distinct_colours(level_of({one, other}), quiet);
  EXPECT_EQ(blocks.first_block, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(blocks.weight, (std::vector<float>{2.0f}));
}

TEST(DistinctColours, IgnoreTheAlphaOfBlocksOfOneColour) {
  BlockTexels thin = filled({10, 20, 30, 51});
  thin[4].a = 0;
  Progress quiet;
  const auto blocks = distinct_colours(level_of({filled({10, 20, 30, 255}), thin}), quiet);
  EXPECT_EQ(blocks.kind_of_block, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_NEAR(blocks.weight[0], 1.0 + 0.2 * 15.0 / 16.0, 1e-6);  // float rounding
}

TEST(DistinctAlphas, NumberKindsByTheirFirstBlockAndLeaveOutPruned) {
  const BlockTexels a = filled({1, 1, 1, 200}), b = filled({1, 1, 1, 100}),
                    none = filled({9, 9, 9, 0});
  Progress quiet;
  const auto blocks = distinct_alphas(level_of({none, b, a, b, none, a, a}), quiet);
  EXPECT_EQ(blocks.kind_of_block, (std::vector<std::uint32_t>{kNoKind, 0, 1, 0, kNoKind, 1, 1}));
  EXPECT_EQ(blocks.first_block, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(blocks.weight, (std::vector<float>{2.0f, 3.0f}));
}

TEST(SampleKinds, KeepsTheTotalWeightAndEveryCommonKind) {
  DistinctBlocks blocks;
  for (std::uint32_t kind = 0; kind < 10000; ++kind) {
    blocks.first_block.push_back(kind);
    blocks.weight.push_back(kind == 4321 ? 5000.0f : 1.0f);
  }
  const KindSample sample = sample_kinds(blocks, 300);
  EXPECT_LE(sample.kinds.size(), 300u);
  EXPECT_GT(sample.kinds.size(), 150u);  // a third of the marks fall on the common kind
  const double total = std::accumulate(sample.weights.begin(), sample.weights.end(), 0.0);
  EXPECT_NEAR(total, 14999.0, 1.0);  // 300 float weights of about 50
  const auto common = std::find(sample.kinds.begin(), sample.kinds.end(), 4321u);
  ASSERT_NE(common, sample.kinds.end());
  const double step = 14999.0 / 300.0;
  EXPECT_NEAR(sample.weights[std::size_t(common - sample.kinds.begin())], 5000.0, step);
}

TEST(SampleKinds, TakesAllWhereTheyAreFew) {
  const DistinctBlocks blocks{{0, 1, 2}, {1.0f, 2.0f, 3.0f}, {}};
  const KindSample sample = sample_kinds(blocks, 3);
  EXPECT_EQ(sample.kinds, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(sample.weights, blocks.weight);
}

}  // namespace
}  // namespace bosk
