#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "core/base/error.h"
#include "core/package/index_coding.h"
#include "core/package/model_check.h"
#include "core/package/parallel.h"

namespace bosk {
namespace {

TEST(RankLists, BeginWithTheNumbersAround) {
  const RankLists lists(12, 10, 5);
  const auto expect_list = [&](std::uint16_t before, const std::vector<std::uint16_t>& followers) {
    for (std::size_t rank = 0; rank < followers.size(); ++rank) {
      EXPECT_EQ(lists.rank(before, followers[rank]), rank) << before << " -> " << followers[rank];
    }
  };
  expect_list(4, {4, 3, 5, 2, 6});
  expect_list(0, {0, 1, 2, 3, 4});
  expect_list(9, {9, 8, 7, 6, 5});
  expect_list(11, {9, 8, 7, 6, 5});  // of a level with more codewords than this one
  EXPECT_EQ(lists.rank(4, 9), lists.length());
}

TEST(RankLists, AreNoLongerThanTheCodebook) {
  EXPECT_EQ(RankLists(3, 3, 255).length(), 3u);
  EXPECT_EQ(RankLists(1, 1, 255).rank(0, 0), 0u);
}

TEST(RankLists, AFollowerTradesPlacesHalfWayToTheFront) {
  RankLists lists(10, 10, 5);
  EXPECT_EQ(lists.take(4, 4), 6);  // 4 3 5 2 6 becomes 4 3 6 2 5
  EXPECT_EQ(lists.rank(4, 6), 2u);
  EXPECT_EQ(lists.rank(4, 5), 4u);
  EXPECT_EQ(lists.take(4, 1), 3);
  EXPECT_EQ(lists.rank(4, 3), 0u);
  lists.learn(4, 9);
  EXPECT_EQ(lists.rank(4, 9), 4u);
  EXPECT_EQ(lists.rank(5, 6), 2u);  // other lists stay: 5 4 6 3 7
}

TEST(RunParallel, RunsEveryTaskOnceAndThrowsTheFirstFailureOfTheList) {
  std::vector<int> runs(20, 0);
  std::vector<std::function<void()>> tasks;
  tasks.reserve(runs.size());
  for (int& run : runs) tasks.push_back([&run] { ++run; });
  run_parallel(tasks, 4);
  run_parallel(tasks, 0);
  EXPECT_EQ(runs, std::vector<int>(20, 2));
  tasks[7] = [] { throw Error("seven"); };
  tasks[3] = [] { throw Error("three"); };
  try {
    run_parallel(tasks, 4);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "three");
  }
}

TEST(IndexOrder, ViewOrderAndBackIsTheSame) {
  for (const std::size_t blocks : {1u, 4u}) {
    const IndexShape shape{131, 3, blocks};
    std::vector<std::uint16_t> values(shape.count()), back(shape.count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint16_t(i);
    const auto by_view = view_order(values, shape);
    EXPECT_EQ(by_view[blocks], values[3 * blocks]);  // second cell of the first view
    cell_order(by_view, shape, back);
    EXPECT_EQ(back, values);
  }
}

TEST(IndexChunks, ShareALevelWithoutGapOrOverlap) {
  for (const std::size_t per_cell : {1u, 12u, 96u, 3'000'000u}) {
    const IndexShape shape{per_cell > 1000 ? 3u : 2'500'000u / std::uint32_t(per_cell), per_cell,
                           1};
    std::size_t next = 0;
    for (const IndexChunk& chunk : index_chunks(shape)) {
      EXPECT_EQ(chunk.first, next);
      EXPECT_TRUE(chunk.shape.cells == 1 || chunk.shape.count() <= kChunkIndices);
      next += chunk.shape.cells;
    }
    EXPECT_EQ(next, shape.cells);
  }
  EXPECT_TRUE(index_chunks({5, 0, 1}).empty());
  EXPECT_TRUE(index_chunks({0, 5, 1}).empty());
}

TEST(FirstPast, IsTheFirstLiveIndexOfTheParent) {
  const std::vector<std::uint64_t> children{8, 9, 17, 40}, cells{1, 2, 3};
  const std::vector<std::uint16_t> alpha{kPruned, 4, kPruned, kPruned, 6, 7};
  const std::vector<std::uint16_t> colour{0, 14, 0, 0, 16, 17};
  const ParentIndices parents{children, cells, 3, alpha, colour, 2};
  const auto past = first_past({0, {4, 1, 1}}, &parents);
  ASSERT_EQ(past.size(), 4u);
  EXPECT_EQ(past[0].before, 14);
  EXPECT_EQ(past[1].before, 14);
  EXPECT_EQ(past[2].before, kPruned);  // the parent is pruned in all views
  EXPECT_EQ(past[3].before, kPruned);  // there is no parent
}

TEST(CleanText, IsUtf8WithoutControls) {
  for (const char* good : {"", "Eiche", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x8c\xb3", "a\tb\n"}) {
    EXPECT_TRUE(is_clean_text(good)) << good;
  }
  // Stray continuation, cut short, overlong, surrogate, beyond Unicode, escape, C1 control.
  for (const char* bad : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                          "\xf4\x90\x80\x80", "\x1b[2J", "\xc2\x9b", "\x7f", "\xff"}) {
    EXPECT_FALSE(is_clean_text(bad)) << bad;
  }
}

}  // namespace
}  // namespace bosk
