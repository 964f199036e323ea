#include "core/package/codebook_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/compress/rate_distortion.h"
#include "core/package/assemble.h"
#include "core/package/billboard_sample.h"
#include "core/package/writer.h"
#include "tests/compress/leafy_billboards.h"

namespace bosk {
namespace {

using testing::leafy_billboards;

// Levels `first` to `last` of a full octree branch by branch: `cells` of the first level, each with
// two children, each with two.
Billboards leafy_tree(int first, int last, int cells) {
  Billboards tree;
  std::vector<std::uint64_t> codes(static_cast<std::size_t>(cells));
  std::iota(codes.begin(), codes.end(), std::uint64_t(0));
  for (int number = first; number <= last; ++number) {
    const Billboards one = leafy_billboards({.cells = int(codes.size()), .views = 2});
    tree.view_positions = one.view_positions;
    tree.levels.push_back(one.levels[0]);
    tree.levels.back().level = number;
    tree.levels.back().cells = codes;
    std::vector<std::uint64_t> children;
    for (const std::uint64_t code : codes)
      children.insert(children.end(), {8 * code, 8 * code + 5});
    codes = children;
  }
  return tree;
}

TEST(SampleOf, TakesWholeSubtreesAndEveryCellAboveThem) {
  const Billboards tree = leafy_tree(4, 6, 2000);
  const BillboardSample sample = sample_of(tree, block_count(tree) / 4);
  ASSERT_EQ(sample.billboards.levels.size(), 3u);
  // The first level with 1000 subtrees for each one taken is the second, of 4000 cells
  EXPECT_EQ(sample.billboards.levels[0].cells, tree.levels[0].cells);
  EXPECT_EQ(sample.billboards.levels[1].cells.size(), 1000u);
  const auto& roots = sample.billboards.levels[1].cells;
  const std::set<std::uint64_t> chosen(roots.begin(), roots.end());
  EXPECT_EQ(sample.billboards.levels[2].cells.size(), 2000u);
  for (const std::uint64_t cell : sample.billboards.levels[2].cells) {
    EXPECT_EQ(chosen.count(cell >> 3), 1u);
  }
  EXPECT_EQ(sample.scale, (std::vector<double>{1.0, 4.0, 4.0}));
}

TEST(SampleOf, KeepsTheTexturesOfTheCellsTaken) {
  const Billboards tree = leafy_tree(4, 5, 4000);
  const BillboardSample sample = sample_of(tree, block_count(tree) / 3);
  const BillboardLevel &all = tree.levels[1], &some = sample.billboards.levels[1];
  ASSERT_LT(some.cells.size(), all.cells.size());
  const std::size_t texels = all.views.size() * all.texture_size();
  for (const std::size_t i : {std::size_t(0), some.cells.size() - 1}) {
    const auto at = std::size_t(
        std::lower_bound(all.cells.begin(), all.cells.end(), some.cells[i]) - all.cells.begin());
    for (std::size_t k = 0; k < texels; ++k) {
      EXPECT_EQ(some.texture[i * texels + k], all.texture[at * texels + k]);
    }
  }
}

TEST(CodebookCurve, IsTheTruthForASmallTree) {
  const Billboards tree = leafy_tree(3, 4, 300);  // taken whole
  CompressOptions options;
  options.colour_codewords = options.alpha_codewords = 32;
  Progress quiet;
  const CodedTextures coded = compress_billboards(tree, options, quiet);
  const OverallPsnr psnr = overall_psnr(rate_distortion(tree, coded, false, quiet));
  const auto package = package_bytes(assemble_tree(tree, coded, {}), quiet);

  const auto curve = codebook_curve(tree, {}, std::vector<int>{32}, quiet);
  ASSERT_EQ(curve.size(), 1u);
  EXPECT_EQ(curve[0].codewords, 32);
  EXPECT_NEAR(curve[0].colour_psnr_db, psnr.colour_db, 1e-9);
  EXPECT_NEAR(curve[0].alpha_psnr_db, psnr.alpha_db, 1e-9);
  // Sections are padded to 8 bytes: up to 7 for each of 13
  EXPECT_NEAR(double(curve[0].package_bytes()), double(package.size()), 7.0 * 13.0);
}

TEST(CodebookCurve, TellsEachPointAsMoreCodewordsCostAndKeepMore) {
  const Billboards tree = leafy_tree(3, 4, 300);
  std::vector<int> told;
  Progress quiet;
  const auto curve =
      codebook_curve(tree, {}, std::vector<int>{16, 64, 256}, quiet,
                     [&](const CodebookPoint& point) { told.push_back(point.codewords); });
  EXPECT_EQ(told, (std::vector<int>{16, 64, 256}));
  ASSERT_EQ(curve.size(), 3u);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_GT(curve[i].colour_psnr_db, curve[i - 1].colour_psnr_db);
    EXPECT_GT(curve[i].alpha_psnr_db, curve[i - 1].alpha_psnr_db);
    EXPECT_GT(curve[i].colour_bytes, curve[i - 1].colour_bytes);
    EXPECT_GT(curve[i].alpha_bytes, curve[i - 1].alpha_bytes);
    // The table of levels tells how many codewords there are: a few bytes more or less
    EXPECT_NEAR(double(curve[i].other_bytes), double(curve[0].other_bytes), 16.0);
  }
}

TEST(CodebookCurve, CountsALevelWithoutCellsAsNothing) {
  Billboards tree = leafy_tree(3, 4, 300);
  tree.levels.back().cells.clear();
  tree.levels.back().texture.clear();
  Progress quiet;
  const auto curve = codebook_curve(tree, {}, std::vector<int>{16, 64}, quiet);
  ASSERT_EQ(curve.size(), 2u);
  EXPECT_GT(curve[1].package_bytes(), curve[0].package_bytes());
}

TEST(AtCodewords, IsStraightOverTheLogarithmAndEndsWithTheCurve) {
  const std::vector<CodebookPoint> curve{{16, 20.0, 10.0, 1000, 100, 7},
                                         {64, 24.0, 30.0, 3000, 500, 7}};
  const CodebookPoint middle = at_codewords(curve, 32);  // half the way from 16 to 64
  EXPECT_EQ(middle.codewords, 32);
  EXPECT_NEAR(middle.colour_psnr_db, 22.0, 1e-12);
  EXPECT_NEAR(middle.alpha_psnr_db, 20.0, 1e-12);
  EXPECT_EQ(middle.package_bytes(), 2000u + 300u + 7u);
  EXPECT_EQ(at_codewords(curve, 2).codewords, 16);
  EXPECT_EQ(at_codewords(curve, 4096).codewords, 64);
}

TEST(CodebookCurve, LeavesOutWhatDoesNotFitIntoTheAtlas) {
  const Billboards tree = leafy_tree(4, 6, 2200);  // 3 levels, 4096 codewords each: 12288 tiles
  Billboards larger = tree;
  for (int i = 0; i < 2; ++i) larger.levels.push_back(tree.levels.back());  // 20480 tiles
  larger.levels[3].level = 7, larger.levels[4].level = 8;
  Progress quiet;
  EXPECT_TRUE(codebook_curve(larger, {}, std::vector<int>{4096}, quiet).empty());
}

TEST(CodebookCurve, StopsWhenCancelled) {
  const Billboards tree = leafy_tree(3, 4, 100);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(codebook_curve(tree, {}, std::vector<int>{16}, progress), Cancelled);
}

}  // namespace
}  // namespace bosk
