#include "core/compress/compress.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/compress/rate_distortion.h"
#include "leafy_billboards.h"

namespace bosk {
namespace {

using testing::leafy_billboards;
using testing::LeafyOptions;

Billboards one_level(std::vector<BlockTexels> blocks) {
  Billboards billboards;
  BillboardLevel& level = billboards.levels.emplace_back();
  level.level = 5;
  level.views = {0};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    level.cells.push_back(i);
    level.texture.insert(level.texture.end(), blocks[i].begin(), blocks[i].end());
  }
  return billboards;
}

BlockTexels filled(glm::u8vec4 texel) {
  BlockTexels block;
  block.fill(texel);
  return block;
}

BlockTexels decoded(const CodedTextures& textures, std::size_t block) {
  return decoded_block(textures, textures.atlas_rgba, 0, block);
}

CodedTextures compress(const Billboards& billboards, const CompressOptions& options = {}) {
  Progress quiet;
  return compress_billboards(billboards, options, quiet);
}

bool same(const CodedTextures& a, const CodedTextures& b) {
  const auto same_level = [](const CodedLevel& x, const CodedLevel& y) {
    return x.alpha_indices == y.alpha_indices && x.colour_indices == y.colour_indices &&
           x.first_alpha_tile == y.first_alpha_tile && x.alpha_codewords == y.alpha_codewords &&
           x.first_colour_tile == y.first_colour_tile && x.colour_codewords == y.colour_codewords;
  };
  return std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                    same_level) &&
         a.atlas_width_px == b.atlas_width_px && a.atlas_height_px == b.atlas_height_px &&
         a.atlas_rgba == b.atlas_rgba && a.atlas_bc3 == b.atlas_bc3;
}

TEST(CompressBillboards, IsExactWhereCodewordsSufficeForAllBlocks) {
  const Billboards trees = leafy_billboards({.cells = 40, .views = 5});  // 200 blocks
  const CodedTextures textures = compress(trees);
  EXPECT_LT(textures.levels[0].colour_codewords, 200u);
  for (std::size_t block = 0; block < 200; ++block) {
    const BlockTexels truth = block_texels(trees.levels[0], block);
    const BlockTexels got = decoded(textures, block);
    for (std::size_t i = 0; i < 16; ++i) {
      ASSERT_EQ(got[i].a, truth[i].a);
      if (truth[i].a > 0) {
        ASSERT_EQ(got[i], truth[i]);
      }
    }
  }
}

TEST(CompressBillboards, MarksPrunedBlocksAndSpendsNoCodewordsOnThem) {
  const auto textures =
      compress(one_level({filled({0, 0, 0, 0}), filled({9, 8, 7, 255}), filled({5, 5, 5, 0})}));
  const CodedLevel& level = textures.levels[0];
  EXPECT_EQ(level.alpha_indices, (std::vector<std::uint16_t>{kPrunedIndex, 0, kPrunedIndex}));
  EXPECT_EQ(level.colour_indices, (std::vector<std::uint16_t>{0, 0, 0}));
  EXPECT_EQ(level.alpha_codewords, 1u);
  EXPECT_EQ(level.colour_codewords, 1u);
}

TEST(CompressBillboards, TakesALevelWhereAllIsPruned) {
  Billboards trees = one_level(std::vector(10, filled({0, 0, 0, 0})));
  trees.levels.push_back(one_level({filled({9, 8, 7, 255})}).levels[0]);
  const CodedTextures textures = compress(trees);
  EXPECT_EQ(textures.levels[0].alpha_codewords, 0u);
  EXPECT_EQ(textures.levels[0].alpha_indices, std::vector(10, kPrunedIndex));
  EXPECT_EQ(decoded_block(textures, textures.atlas_rgba, 1, 0), filled({9, 8, 7, 255}));
}

TEST(CompressBillboards, TakesNoLevelsAtAll) {
  const CodedTextures textures = compress(Billboards{});
  EXPECT_TRUE(textures.levels.empty());
  EXPECT_EQ(textures.atlas_width_px, 4);  // one empty tile, which a graphics card can hold
  EXPECT_EQ(textures.atlas_rgba.size(), 16u);
  EXPECT_EQ(textures.atlas_bc3.size(), 16u);
}

// 30 x 0.2 and 90 x 0.6 opaque: the light-weighted mean is (30 x 0.2 + 90 x 0.6) / 0.8 = 75.
TEST(CompressBillboards, OfOneCodewordIsTheMeanThatCountsByAlpha) {
  BlockTexels dark = filled({30, 30, 30, 51}), bright = filled({90, 90, 90, 153});
  const CodedTextures textures =
      compress(one_level({dark, bright}), {.colour_codewords = 1, .alpha_codewords = 1});
  EXPECT_EQ(decoded(textures, 0), filled({75, 75, 75, 102}));
  EXPECT_EQ(decoded(textures, 1), filled({75, 75, 75, 102}));
}

// Clear texels are black here, as renderers leave them; half of every block is clear.
TEST(CompressBillboards, DoesNotDarkenByClearTexels) {
  std::vector<BlockTexels> blocks;
  Random random(4);
  for (int b = 0; b < 400; ++b) {
    BlockTexels& block = blocks.emplace_back(filled({0, 0, 0, 0}));
    for (std::size_t i = 0; i < 16; ++i) {
      const auto level = std::uint8_t(150 + random.below(20));
      if (random.uniform() < 0.5) block[i] = {level, level, level, 255};
    }
    block[random.below(16)] = {160, 160, 160, 255};
  }
  const Billboards trees = one_level(blocks);
  const CodedTextures textures = compress(trees, {.colour_codewords = 8, .alpha_codewords = 8});
  double truth = 0.0, got = 0.0, visible = 0.0;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const BlockTexels texels = decoded(textures, block);
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_GE(texels[i].r, 150);  // clear or not: nothing darker was ever visible
      if (blocks[block][i].a == 0) continue;
      truth += blocks[block][i].r;
      got += texels[i].r;
      visible += 1.0;
    }
  }
  EXPECT_NEAR(got / visible, truth / visible, 0.5);  // codewords are rounded to whole numbers
}

TEST(CompressBillboards, SearchesColoursAloneWhereBlocksHaveOneColour) {
  std::vector<BlockTexels> blocks;
  Random random(6);
  for (int b = 0; b < 3000; ++b) {
    const auto bits = random.bits();
    blocks.push_back(filled({bits & 127, (bits >> 8) & 127, (bits >> 16) & 63, 255}));
    for (std::size_t i = 0; i < 16; ++i) blocks.back()[i].a = std::uint8_t(random.below(256));
  }
  const CodedTextures textures = compress(one_level(blocks), {.colour_codewords = 256});
  const CodedLevel& level = textures.levels[0];
  EXPECT_LE(level.colour_codewords, 256u);
  double square = 0.0;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    const BlockTexels texels = decoded(textures, block);
    EXPECT_EQ(glm::u8vec3(texels[0]), glm::u8vec3(texels[15]));
    const glm::vec3 error = glm::vec3(texels[0]) - glm::vec3(blocks[block][0]);
    square += double(glm::dot(error, error)) / 3.0;
  }
  // A box of 128 x 128 x 64 in 256 cubes of edge 16 has an error of 16 / sqrt(12) = 4.6 a channel;
  // cubes in perceptual space, whose sizes vary by the colour, do not much worse: 5.4 measured.
  EXPECT_LT(std::sqrt(square / double(blocks.size())), 1.5 * 4.6);
}

TEST(CompressBillboards, NumbersCodewordsByBrightnessAndOpacity) {
  const Billboards trees = leafy_billboards({.cells = 60, .views = 6});
  const CodedTextures textures = compress(trees, {.colour_codewords = 20, .alpha_codewords = 20});
  const auto mean = [&](std::uint32_t tile, auto&& value) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 16; ++i) {
      const std::size_t across = std::size_t(textures.atlas_width_px) / 4;
      const std::size_t x = 4 * (tile % across) + i % 4, y = 4 * (tile / across) + i / 4;
      sum += value(textures.atlas_rgba[y * std::size_t(textures.atlas_width_px) + x]);
    }
    return sum;
  };
  const auto luma = [](glm::u8vec4 t) { return 0.299 * t.r + 0.587 * t.g + 0.114 * t.b; };
  const auto alpha = [](glm::u8vec4 t) { return double(t.a); };
  for (std::uint32_t k = 1; k < 20; ++k) {
    EXPECT_LE(mean(k - 1, luma), mean(k, luma));
    EXPECT_LE(mean(k - 1, alpha), mean(k, alpha));
  }
}

TEST(CompressBillboards, PicksInputBlocksByThePapersRule) {
  std::vector<BlockTexels> blocks;
  Random random(9);
  for (int b = 0; b < 300; ++b) {
    BlockTexels& block = blocks.emplace_back(filled({0, 0, 0, 255}));
    for (auto& texel : block) texel.g = std::uint8_t(random.below(256));
  }
  const std::set<std::string> inputs = [&] {
    std::set<std::string> set;
    for (const auto& block : blocks) {
      set.emplace(reinterpret_cast<const char*>(block.data()), sizeof(block));
    }
    return set;
  }();
  const auto textures =
      compress(one_level(blocks), {.colour_codewords = 16, .codeword_rule = "closest_block"});
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BlockTexels block = decoded(textures, b);
    EXPECT_TRUE(inputs.contains({reinterpret_cast<const char*>(block.data()), sizeof(block)}));
  }
}

// Bias is what adds up where billboards overlap: light that passes 8 blocks, each with its own
// error. The mean over 4000 stacks of 16 rays is known to about 0.06 / sqrt(4000) = 0.001, 0.06
// being the error of one ray; rounding codewords to 8 bits may add 0.5 / 255 / sqrt(64 codewords) a
// block, a few 1e-4.
TEST(CompressBillboards, KeepsTheMeanTransmittanceOfStacks) {
  const Billboards trees = leafy_billboards({.cells = 300, .leaves = 20, .leaf_size = 0.1});
  const CodedTextures textures = compress(trees, {.alpha_codewords = 64});
  const std::size_t blocks = block_count(trees.levels[0]);
  Random random(11);
  double bias = 0.0;
  for (int stack = 0; stack < 4000; ++stack) {
    std::array<double, 16> truth, got;
    truth.fill(1.0);
    got.fill(1.0);
    for (int depth = 0; depth < 8; ++depth) {
      const std::size_t block = random.below(blocks);
      const BlockTexels a = block_texels(trees.levels[0], block), b = decoded(textures, block);
      for (std::size_t i = 0; i < 16; ++i) {
        truth[i] *= 1.0 - a[i].a / 255.0;
        got[i] *= 1.0 - b[i].a / 255.0;
      }
    }
    for (std::size_t i = 0; i < 16; ++i) bias += (got[i] - truth[i]) / 16.0;
  }
  EXPECT_LT(std::abs(bias / 4000.0), 0.003);  // three standard errors
}

TEST(CompressBillboards, SameWithOneThreadAndMany) {
  const Billboards trees = leafy_billboards({.cells = 200, .views = 8, .texels = 8});
  const CompressOptions options{.colour_codewords = 100, .alpha_codewords = 100};
  const CodedTextures many = compress(trees, options);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(same(compress(trees, options), many));
}

TEST(CompressBillboards, RefusesTexturesOfAnotherSize) {
  Billboards trees = leafy_billboards({.cells = 3});
  trees.levels[0].texture.pop_back();
  EXPECT_THROW(compress(trees), Error);
  trees.levels[0].texels = 6;
  EXPECT_THROW(compress(trees), Error);
}

TEST(CompressBillboards, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(compress_billboards(leafy_billboards({.cells = 3}), {}, progress), Cancelled);
}

TEST(CompressBillboards, ReportsEveryFractionInOrder) {
  double last = 0.0;
  bool ordered = true;
  Progress progress(
      [&](const ProgressReport& report) {
        ordered = ordered && report.fraction >= last && report.fraction <= 1.0;
        last = report.fraction;
      },
      {});
  compress_billboards(leafy_billboards({.cells = 100, .views = 12}), {.colour_codewords = 30},
                      progress);
  EXPECT_TRUE(ordered);
  EXPECT_GE(last, 0.9);  // the last step, the atlas, has begun
}

TEST(CodedTextures, ReadBackAsWritten) {
  const CodedTextures textures = compress(leafy_billboards({.cells = 20}));
  BinaryWriter writer;
  write(writer, textures);
  BinaryReader reader(writer.bytes());
  EXPECT_TRUE(same(read_coded_textures(reader), textures));
  EXPECT_TRUE(reader.at_end());
}

TEST(CodedTextures, RefuseACutOrGarbledResult) {
  BinaryWriter writer;
  write(writer, compress(leafy_billboards({.cells = 20})));
  for (const std::size_t size : {0u, 7u, 100u}) {
    BinaryReader reader(std::span(writer.bytes()).first(size));
    EXPECT_THROW(read_coded_textures(reader), Error);
  }
  const std::vector<std::byte> garbage(64, std::byte{0xff});
  BinaryReader reader(garbage);
  EXPECT_THROW(read_coded_textures(reader), Error);
}

TEST(CompressOptions, DescribeEveryDefaultWithinItsRange) {
  CompressOptions options;
  for (const Option& option : describe(options)) {
    EXPECT_NO_THROW(set_value(option, value_text(option))) << option.name;
  }
}

}  // namespace
}  // namespace bosk
