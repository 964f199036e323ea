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
  const RankLists lists(10, 5);
  const auto expect_list = [&](std::uint16_t before, const std::vector<std::uint16_t>& followers) {
    for (std::size_t rank = 0; rank < followers.size(); ++rank) {
      EXPECT_EQ(lists.rank(before, followers[rank]), rank) << before << " -> " << followers[rank];
    }
  };
  expect_list(4, {4, 3, 5, 2, 6});
  expect_list(0, {0, 1, 2, 3, 4});
  expect_list(9, {9, 8, 7, 6, 5});
  EXPECT_EQ(lists.rank(4, 9), lists.length());
}

TEST(RankLists, AreNoLongerThanTheCodebook) {
  EXPECT_EQ(RankLists(3, 255).length(), 3u);
  EXPECT_EQ(RankLists(1, 255).rank(0, 0), 0u);
}

TEST(RankLists, AFollowerTradesPlacesHalfWayToTheFront) {
  RankLists lists(10, 5);
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
  for (const std::size_t blocks : {1, 4}) {
    const IndexShape shape{131, 3, blocks};
    std::vector<std::uint16_t> values(shape.count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint16_t(i);
    const auto by_view = view_order(values, shape);
    EXPECT_EQ(by_view[blocks], values[3 * blocks]);  // second cell of the first view
    EXPECT_EQ(cell_order(by_view, shape), values);
  }
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
