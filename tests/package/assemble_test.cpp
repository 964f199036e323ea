#include "core/package/assemble.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace bosk {
namespace {

// Two cells of level 1, two views, 4x4 texels: the second cell is pruned in both views.
Billboards two_cells() {
  Billboards billboards;
  billboards.origin = {-1.0, -1.0, 0.5};
  billboards.size_m = 2.0;
  billboards.view_positions = {{5.0, 0.0, 1.0}, {0.0, 5.0, 1.0}};
  BillboardLevel level;
  level.level = 1;
  level.side_factor = 1.25f;
  level.max_cell_px = 3.0f;
  level.views = {0, 1};
  level.cells = {3, 4};  // z = 0 and z = 1
  level.texture.resize(std::size_t(2) * 2 * 16);
  billboards.levels = {level};
  return billboards;
}

CodedTextures two_coded_cells() {
  CodedTextures textures;
  CodedLevel level;
  level.alpha_indices = {kPrunedIndex, 1, kPrunedIndex, kPrunedIndex};
  level.colour_indices = {0, 2, 0, 0};
  level.first_alpha_tile = 1;
  level.alpha_codewords = 2;
  level.first_colour_tile = 0;
  level.colour_codewords = 3;
  textures.levels = {level};
  textures.atlas_width_px = 16;
  textures.atlas_height_px = 4;
  textures.atlas_rgba.resize(64);
  textures.atlas_bc3.resize(64);
  return textures;
}

TEST(AssembleTree, DropsCellsThatNoViewShows) {
  TreeMetadata metadata;
  metadata.name = "pine";
  const TreeModel tree = assemble_tree(two_cells(), two_coded_cells(), metadata);
  ASSERT_EQ(tree.levels.size(), 1u);
  const TreeLevel& level = tree.levels[0];
  EXPECT_EQ(level.cells, std::vector<std::uint64_t>{3});
  EXPECT_EQ(level.alpha_indices, (std::vector<std::uint16_t>{kPruned, 1}));
  EXPECT_EQ(level.colour_indices, (std::vector<std::uint16_t>{0, 2}));
  EXPECT_EQ(level.alpha_codes.first, 1u);
  EXPECT_EQ(level.colour_codes.count, 3u);
  EXPECT_EQ(tree.metadata.name, "pine");
}

TEST(AssembleTree, HeightIsTheTopOfTheHighestCellKept) {
  EXPECT_DOUBLE_EQ(assemble_tree(two_cells(), two_coded_cells(), {}).metadata.height_m, 1.5);
  CodedTextures both = two_coded_cells();
  both.levels[0].alpha_indices[2] = 0;
  EXPECT_DOUBLE_EQ(assemble_tree(two_cells(), both, {}).metadata.height_m, 2.5);
}

TEST(AssembleTree, RefusesTexturesOfOtherBillboards) {
  CodedTextures short_one = two_coded_cells();
  short_one.levels[0].alpha_indices.pop_back();
  EXPECT_THROW(assemble_tree(two_cells(), short_one, {}), Error);
  CodedTextures more_levels = two_coded_cells();
  more_levels.levels.push_back(more_levels.levels[0]);
  EXPECT_THROW(assemble_tree(two_cells(), more_levels, {}), Error);
}

}  // namespace
}  // namespace bosk
