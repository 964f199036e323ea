#include "core/compress/level_statistics.h"

#include <gtest/gtest.h>

#include "leafy_billboards.h"

namespace bosk {
namespace {

using testing::leafy_billboards;

TEST(LevelStatistics, CountCellsTexturesAndWhatIsPruned) {
  Billboards trees = leafy_billboards({.cells = 10, .views = 6, .texels = 8, .pruned = 0.0});
  BillboardLevel& level = trees.levels[0];
  for (glm::u8vec4& texel : level.texture) texel.a = 255;
  for (std::size_t i = 0; i < 3 * 64; ++i) level.texture[7 * 64 + i].a = 0;  // textures 7 to 9
  level.texture[8 * 64 + 5].a = 1;                                           // but not 8
  const LevelStatistics row = level_statistics(trees).at(0);
  EXPECT_EQ(row.level, level.level);
  EXPECT_EQ(row.cells, 10u);
  EXPECT_EQ(row.views, 6u);
  EXPECT_EQ(row.textures, 60u);
  EXPECT_EQ(row.kept, 58u);
  EXPECT_EQ(row.blocks, 240u);  // four blocks of 4x4 a texture
  EXPECT_EQ(row.raw_bytes, 60u * 64u * 4u);
  EXPECT_EQ(row.index_bytes, 240u * 4u);
  EXPECT_DOUBLE_EQ(row.pruned_share(), 2.0 / 60.0);
}

TEST(FullestCell, IsTheOneThatStopsMostLight) {
  Billboards trees = leafy_billboards({.cells = 30, .views = 2});
  BillboardLevel& level = trees.levels[0];
  for (std::size_t i = 0; i < 2 * 16; ++i) level.texture[17 * 2 * 16 + i].a = 255;
  EXPECT_EQ(fullest_cell(level), 17u);
}

TEST(TexturesKept, AgreeBeforeAndAfterCoding) {
  const Billboards trees = leafy_billboards({.cells = 50, .texels = 8, .pruned = 0.4});
  Progress quiet;
  const CodedTextures coded = compress_billboards(trees, {}, quiet);
  EXPECT_EQ(textures_kept(coded.levels[0].alpha_indices, 4), level_statistics(trees)[0].kept);
}

}  // namespace
}  // namespace bosk
