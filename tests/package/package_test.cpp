#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <span>

#include "core/package/index_coding.h"
#include "core/package/reader.h"
#include "core/package/writer.h"
#include "core/package/zstd_encode.h"
#include "tests/package/package_parts.h"
#include "tests/package/sample_tree.h"

namespace bosk {
namespace {

std::string package_of(const TreeModel& tree) {
  Progress progress;
  const auto bytes = package_bytes(tree, progress);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TreeModel read(const std::string& package) {
  return read_tree(std::as_bytes(std::span(package)), "oak.bosk");
}

std::string refusal(const std::string& package) {
  try {
    read(package);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void expect_round_trip(const TreeModel& tree) {
  EXPECT_TRUE(same_tree(read(package_of(tree)), tree));
}

TEST(TreePackage, ReadsBackWhatWasWritten) {
  expect_round_trip(sample_tree({}));
  expect_round_trip(sample_tree({.levels = {1, 2, 4}, .texels = 8, .views = 24}));
  expect_round_trip(sample_tree({.levels = {5}, .alpha_codewords = 512, .colour_codewords = 1024}));
}

TEST(TreePackage, ReadsBackExtremes) {
  expect_round_trip(TreeModel{});
  expect_round_trip(sample_tree({.levels = {}}));
  expect_round_trip(sample_tree({.levels = {0, 3}}));  // the root's cell lies within the shell
  expect_round_trip(sample_tree({.alpha_codewords = 1, .colour_codewords = 1}));
  expect_round_trip(sample_tree({.views = 0}));
  expect_round_trip(sample_tree({.alpha_codewords = 4096, .colour_codewords = 4096}));
}

TEST(TreePackage, ReadsBackALevelThatIsPrunedWholly) {
  TreeModel tree = sample_tree({});
  for (TreeLevel& level : tree.levels) {
    std::fill(level.alpha_indices.begin(), level.alpha_indices.end(), kPruned);
    std::fill(level.colour_indices.begin(), level.colour_indices.end(), std::uint16_t(0));
    level.alpha_codes = level.colour_codes = {0, 0};
  }
  expect_round_trip(tree);
}

TEST(TreePackage, ReadsBackCodebooksAnywhereInTheAtlasAndRaggedIndices) {
  TreeModel tree = sample_tree({.levels = {4}, .alpha_codewords = 300, .colour_codewords = 300});
  TreeLevel& level = tree.levels[0];
  level.alpha_codes = {100, 200};
  level.colour_codes = {17, 283};
  for (std::size_t i = 0; i < level.alpha_indices.size(); ++i) {
    if (level.alpha_indices[i] == kPruned) continue;
    level.alpha_indices[i] = std::uint16_t(i * 7919 % 200);
    level.colour_indices[i] = std::uint16_t(i * 6007 % 283);
  }
  expect_round_trip(tree);
}

TEST(TreePackage, SameTreeGivesTheSameBytesWithOneThreadAndMany) {
  const TreeModel tree = sample_tree({.levels = {2, 3, 4, 5}});
  const std::string many = package_of(tree);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(package_of(tree), many);
}

// Low bytes, then high bytes, of what is live, view by view: the best order for zstd alone.
std::size_t zstd_bytes(const TreeLevel& level, const std::vector<std::uint16_t>& indices) {
  const IndexShape shape{level.cells.size(), level.views.size(), 1};
  const auto alpha = view_order(level.alpha_indices, shape), values = view_order(indices, shape);
  std::vector<std::byte> low, high;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (alpha[i] == kPruned) continue;
    low.push_back(std::byte(values[i] & 0xff));
    high.push_back(std::byte(values[i] >> 8));
  }
  low.insert(low.end(), high.begin(), high.end());
  return zstd_compress(low, Progress{}).size();
}

// On indices that move to look-alikes, as sample_tree's do; 10 % is what a coder of our own must
// earn.
TEST(TreePackage, RanksTakeATenthLessThanZstdMakesOfTheIndices) {
  const TreeModel tree =
      sample_tree({.levels = {5}, .views = 24, .alpha_codewords = 256, .colour_codewords = 512});
  const TreeLevel& level = tree.levels[0];
  const std::size_t plain =
      zstd_bytes(level, level.alpha_indices) + zstd_bytes(level, level.colour_indices);
  std::size_t ranked = 0;
  for (const PackagePart& part : take_apart(package_of(tree)).parts) {
    if (part.type == kAlphaSection || part.type == kColourSection) ranked += part.bytes.size();
  }
  EXPECT_LT(double(ranked), 0.9 * double(plain));
}

// Leaves keep their colour from the cell they are a part of; so a single view has something to go
// by.
TEST(TreePackage, AColourLikeThatOfTheParentTakesLessThanHalf) {
  TreeModel tree =
      sample_tree({.levels = {4, 5}, .views = 1, .alpha_codewords = 16, .colour_codewords = 1024});
  const auto colour_bytes = [&] {
    const std::string package = package_of(tree);
    EXPECT_TRUE(same_tree(read(package), tree));
    return take_apart(package).parts.back().bytes.size();
  };
  const std::size_t unlike = colour_bytes();
  const TreeLevel& coarse = tree.levels[0];
  TreeLevel& fine = tree.levels[1];
  for (std::size_t i = 0; i < fine.cells.size(); ++i) {
    const auto parent =
        std::lower_bound(coarse.cells.begin(), coarse.cells.end(), fine.cells[i] >> 3);
    if (parent == coarse.cells.end() || *parent != fine.cells[i] >> 3) continue;
    if (fine.alpha_indices[i] == kPruned) continue;
    fine.colour_indices[i] = coarse.colour_indices[std::size_t(parent - coarse.cells.begin())];
  }
  EXPECT_LT(colour_bytes() * 2, unlike);
}

TEST(TreePackage, ReadsBackALevelOfSeveralChunks) {
  TreeModel tree = sample_tree({.levels = {5, 6}, .views = 24});
  ASSERT_GT(tree.levels[1].alpha_indices.size(), kChunkIndices);
  const std::string package = package_of(tree);
  for (const unsigned threads : {1u, 3u}) {
    EXPECT_TRUE(same_tree(read_tree(std::as_bytes(std::span(package)), "", threads), tree));
  }
}

TEST(TreePackage, ReadsBackLevelsThatSkipOneOrWhoseParentsAreMissing) {
  expect_round_trip(sample_tree({.levels = {2, 5}}));
  TreeModel tree = sample_tree({.levels = {3, 4}});
  TreeLevel& coarse = tree.levels[0];
  const std::size_t cells = coarse.cells.size() / 2, indices = cells * coarse.views.size();
  coarse.cells.resize(cells);
  coarse.alpha_indices.resize(indices);
  coarse.colour_indices.resize(indices);
  expect_round_trip(tree);
}

TEST(TreePackage, FindsEveryFlippedByte) {
  const std::string package =
      package_of(sample_tree({.levels = {2}, .alpha_codewords = 8, .colour_codewords = 8}));
  for (std::size_t i = 0; i < package.size(); ++i) {
    std::string damaged_package = package;
    damaged_package[i] = char(damaged_package[i] ^ (1 << (i % 8)));
    EXPECT_NE(refusal(damaged_package), "") << "byte " << i;
  }
}

TEST(TreePackage, RefusesAnyShorterOrLongerFile) {
  const std::string package = package_of(sample_tree({.levels = {2}}));
  for (std::size_t size = 0; size < package.size(); size += 13) {
    EXPECT_NE(refusal(package.substr(0, size)), "") << size;
  }
  EXPECT_NE(refusal(package + std::string(8, '\0')), "");
}

TEST(TreePackage, IsReadTheSameByOneThreadAndMany) {
  const TreeModel tree = sample_tree({.levels = {2, 3, 4, 5}});
  const std::string package = package_of(tree);
  for (const unsigned threads : {1u, 2u, 7u}) {
    EXPECT_TRUE(same_tree(read_tree(std::as_bytes(std::span(package)), "", threads), tree));
  }
}

TEST(TreePackage, RefusalNamesTheFile) {
  EXPECT_THAT(refusal("not a tree at all"), testing::StartsWith("oak.bosk: "));
  EXPECT_THAT(refusal(std::string(100, 'x')), testing::HasSubstr("no Bosk tree package"));
}

TEST(TreePackage, ANewerMajorVersionIsRefusedPolitely) {
  PackageParts apart = take_apart(package_of(sample_tree({})));
  apart.major_version = kMajorVersion + 1;
  EXPECT_THAT(refusal(put_together(apart)), testing::HasSubstr("needs a newer Bosk"));
}

TEST(TreePackage, ANewerMinorVersionOpens) {
  const TreeModel tree = sample_tree({});
  PackageParts apart = take_apart(package_of(tree));
  apart.minor_version = kMinorVersion + 7;
  EXPECT_TRUE(same_tree(read(put_together(apart)), tree));
}

TEST(TreePackage, AnOlderMajorVersionIsToldFromDamage) {
  PackageParts apart = take_apart(package_of(sample_tree({})));
  apart.major_version = kMajorVersion - 1;
  EXPECT_THAT(refusal(put_together(apart)), testing::HasSubstr("no longer reads"));
}

TEST(TreePackage, AnUnknownOptionalSectionIsPassedOverAndAnUnknownRequiredOneRefused) {
  const TreeModel tree = sample_tree({});
  PackageParts apart = take_apart(package_of(tree));
  apart.parts.insert(apart.parts.begin(), {section_type("WIND"), 3, 9, 0, "sway", 400});
  EXPECT_TRUE(same_tree(read(put_together(apart)), tree));
  apart.parts[0].flags = kRequired;
  EXPECT_THAT(refusal(put_together(apart)), testing::HasSubstr("'WIND 3'"));
}

TEST(TreePackage, EachMissingOrDoubledSectionIsRefused) {
  const PackageParts whole = take_apart(package_of(sample_tree({})));
  for (std::size_t i = 0; i < whole.parts.size(); ++i) {
    PackageParts less = whole, more = whole;
    less.parts.erase(less.parts.begin() + std::ptrdiff_t(i));
    more.parts.push_back(whole.parts[i]);
    EXPECT_THAT(refusal(put_together(less)), testing::HasSubstr("missing")) << i;
    EXPECT_THAT(refusal(put_together(more)), testing::HasSubstr("twice")) << i;
  }
}

TEST(TreePackage, ABombIsRefusedBeforeItUnpacks) {
  PackageParts apart = take_apart(package_of(sample_tree({})));
  apart.parts[0].codec = kZstd;
  apart.parts[0].raw_length = std::uint64_t(1) << 40;
  EXPECT_THAT(refusal(put_together(apart)), testing::HasSubstr("too tightly"));
}

// Every promise of tree_model.h, broken one at a time: the writer refuses.
TEST(TreePackage, WriterRefusesATreeThatBreaksAPromise) {
  const TreeModel good = sample_tree({});
  const auto expect_refused = [&](const char* what, auto&& harm) {
    TreeModel bad = good;
    harm(bad);
    EXPECT_THROW(package_of(bad), Error) << what;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused("origin", [&](TreeModel& t) { t.origin.y = nan; });
  expect_refused("size", [](TreeModel& t) { t.size_m = 0.0; });
  expect_refused("view", [&](TreeModel& t) { t.view_positions[1].x = 1.0 / 0.0 * 0.0; });
  expect_refused("height", [&](TreeModel& t) { t.metadata.height_m = nan; });
  expect_refused("text", [](TreeModel& t) { t.metadata.credit = "\xff"; });
  expect_refused("order of levels", [](TreeModel& t) { std::swap(t.levels[0], t.levels[1]); });
  expect_refused("texels", [](TreeModel& t) { t.levels[0].texels = 5; });
  expect_refused("side factor", [](TreeModel& t) { t.levels[0].side_factor = -1.0f; });
  expect_refused("cell size", [](TreeModel& t) { t.levels[0].max_cell_px = -1.0f; });
  expect_refused("level", [](TreeModel& t) { t.levels[1].level = 13; });
  expect_refused("view", [](TreeModel& t) { t.levels[0].views[0] = 6; });
  expect_refused("cell order", [](TreeModel& t) { t.levels[1].cells[1] = t.levels[1].cells[0]; });
  expect_refused("cell range", [](TreeModel& t) { t.levels[1].cells.back() = 512; });
  expect_refused("index count", [](TreeModel& t) { t.levels[0].alpha_indices.pop_back(); });
  expect_refused("alpha index", [](TreeModel& t) { t.levels[0].alpha_indices[5] = 24; });
  expect_refused("colour index", [](TreeModel& t) { t.levels[0].colour_indices[5] = 40; });
  expect_refused("pruned colour", [](TreeModel& t) {
    t.levels[0].alpha_indices[5] = kPruned;
    t.levels[0].colour_indices[5] = 1;
  });
  expect_refused("codes", [](TreeModel& t) { t.levels[0].alpha_codes.first = 0xffffffff; });
  expect_refused("atlas", [](TreeModel& t) { t.atlas.rgba.pop_back(); });
  expect_refused("atlas", [](TreeModel& t) { t.atlas.bc3.pop_back(); });
  expect_refused("atlas", [](TreeModel& t) { t.atlas.width_px = 516; });
}

TEST(TreePackage, WritingStopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(package_bytes(sample_tree({}), progress), Cancelled);
}

class PackageFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(PackageFile, IsLoadedAgain) {
  Progress progress;
  const TreeModel tree = sample_tree({});
  write_package(folder_ / "oak.bosk", tree, progress);
  EXPECT_TRUE(same_tree(load_tree(folder_ / "oak.bosk"), tree));
}

TEST_F(PackageFile, ThatIsMissingOrAFolderOrAPipeOrEmptyIsRefusedByName) {
  const auto expect_refused = [](const std::filesystem::path& path) {
    try {
      load_tree(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(path.string()));
    }
  };
  expect_refused(folder_ / "missing.bosk");
  expect_refused(folder_);
  const auto pipe = folder_ / "pipe.bosk";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_refused(pipe);
  std::ofstream(folder_ / "empty.bosk").close();
  expect_refused(folder_ / "empty.bosk");
}

}  // namespace
}  // namespace bosk
