#include "core/compress/texture_sheets.h"

#include <gtest/gtest.h>

#include "leafy_billboards.h"

namespace bosk {
namespace {

using testing::leafy_billboards;

const glm::u8vec4& texel_of(const BillboardLevel& level, std::size_t cell, std::size_t view, int x,
                            int y) {
  const std::size_t texture = cell * level.views.size() + view;
  return level.texture[texture * level.texture_size() + std::size_t(y * level.texels + x)];
}

TEST(CellTextures, StandInRowsByView) {
  const Billboards trees = leafy_billboards({.cells = 4, .views = 6, .texels = 8});
  const TileSheet sheet = cell_textures(trees, 0, 2, 4);
  EXPECT_EQ(sheet.tiles, 6);
  EXPECT_EQ(sheet.picture.width(), 4 * 9 - 1);
  EXPECT_EQ(sheet.picture.height(), 2 * 9 - 1);
  EXPECT_EQ(sheet.picture(9 + 3, 9 + 5), texel_of(trees.levels[0], 2, 5, 3, 5));  // row 1, column 1
  EXPECT_EQ(sheet.picture(8, 0), glm::u8vec4(0));                                 // between tiles
}

TEST(CodedCellTextures, AreTheTexturesWhereNothingIsLost) {
  const Billboards trees = leafy_billboards({.cells = 6, .views = 3, .texels = 8});
  Progress quiet;
  const CodedTextures coded = compress_billboards(trees, {}, quiet);  // a codeword for each block
  for (std::size_t cell = 0; cell < 6; ++cell) {
    const TileSheet truth = cell_textures(trees, 0, cell);
    const TileSheet decoded = coded_cell_textures(trees, coded, coded.atlas_rgba, 0, cell);
    ASSERT_EQ(decoded.picture.size(), truth.picture.size());
    for (std::size_t i = 0; i < truth.picture.size(); ++i) {
      const glm::u8vec4 a = truth.picture.pixels()[i], b = decoded.picture.pixels()[i];
      EXPECT_EQ(a.a, b.a);
      if (a.a == 0) continue;  // the colour of clear texels is nobody's
      EXPECT_EQ(a, b);
    }
  }
}

TEST(ViewTextures, ShowCellsFromTheFirstAskedFor) {
  const Billboards trees = leafy_billboards({.cells = 5, .views = 2});
  const TileSheet sheet = view_textures(trees, 0, 1, 3, 10, 8);
  EXPECT_EQ(sheet.tiles, 2);  // cells 3 and 4: there are no more
  EXPECT_EQ(sheet.picture(5 + 2, 1), texel_of(trees.levels[0], 4, 1, 2, 1));
}

TEST(CodedViewTextures, ShowEachCellAsItsOwnSheetDoes) {
  const Billboards trees = leafy_billboards({.cells = 40, .views = 2, .texels = 8});
  Progress quiet;
  const CodedTextures coded =
      compress_billboards(trees, {.colour_codewords = 8, .alpha_codewords = 8}, quiet);
  const auto& atlas = coded.atlas_rgba;
  const TileSheet all = coded_view_textures(trees, coded, atlas, 0, 1, 30, 10, 5);
  const TileSheet one = coded_cell_textures(trees, coded, atlas, 0, 37, 2);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(all.picture(2 * 9 + x, 9 + y), one.picture(9 + x, y));  // tile 7 of 5 across
    }
  }
}

TEST(Codewords, AreShownInTheOrderOfTheAtlas) {
  const Billboards trees = leafy_billboards({.cells = 60});
  Progress quiet;
  const CodedTextures coded =
      compress_billboards(trees, {.colour_codewords = 40, .alpha_codewords = 9}, quiet);
  const TileSheet colours = colour_codewords(coded, 0, 16), alphas = alpha_codewords(coded, 0, 16);
  EXPECT_EQ(colours.tiles, 40);
  EXPECT_EQ(alphas.tiles, 9);
  const auto across = std::size_t(coded.atlas_width_px);
  const glm::u8vec4 second = coded.atlas_rgba[1 * across + 4 + 2];  // tile 1, texel (2, 1)
  EXPECT_EQ(colours.picture(5 + 2, 1), glm::u8vec4(glm::u8vec3(second), 255));
  EXPECT_EQ(alphas.picture(5 + 2, 1), glm::u8vec4(255, 255, 255, second.a));
}

}  // namespace
}  // namespace bosk
