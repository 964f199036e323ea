#include "ui/frame_budget.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace bosk {
namespace {

// A machine that takes `fixed` ms a frame and `per_thousand` ms for each thousand billboards, and
// a view that asks for `wanted` of them.
struct Machine {
  double fixed, per_thousand;
  std::uint64_t wanted;
  double jitter = 0.0;

  FrameCost draw(std::uint64_t budget, Random& random) const {
    const std::uint64_t drawn = budget == 0 ? wanted : std::min(budget, wanted);
    const double noise = random.uniform(1.0 - jitter, 1.0 + jitter);
    return {(fixed + per_thousand * double(drawn) / 1000.0) * noise, drawn};
  }
};

std::uint64_t settled(const Machine& machine, std::uint64_t budget, std::uint64_t most = 0) {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    budget = adapted_budget(budget, machine.draw(budget, random), 30.0, most);
  }
  return budget;
}

TEST(AdaptedBudget, ComesToTheTargetFromAboveAndBelow) {
  const Machine machine{2.0, 0.1, 10000000};  // 280,000 in 30 ms
  for (const std::uint64_t start : {2000u, 50000u, 5000000u}) {
    EXPECT_NEAR(double(settled(machine, start)), 280000.0, 33000.0) << start;  // 27 to 33 ms
  }
}

TEST(AdaptedBudget, StaysPutWithinATenth) {
  EXPECT_EQ(adapted_budget(100000, {31.0, 100000}, 30.0, 0), 100000u);
  EXPECT_EQ(adapted_budget(100000, {28.0, 100000}, 30.0, 0), 100000u);
}

TEST(AdaptedBudget, HoldsUnderJitter) {
  Random random(3);
  const Machine machine{2.0, 0.1, 10000000, 0.15};
  std::uint64_t budget = 280000;
  for (int i = 0; i < 500; ++i) {
    budget = adapted_budget(budget, machine.draw(budget, random), 30.0, 0);
    EXPECT_GT(budget, 150000u);
    EXPECT_LT(budget, 400000u);
  }
}

TEST(AdaptedBudget, DoesNotRunAwayWhereTheViewAsksForLittle) {
  EXPECT_LT(settled({1.0, 0.01, 40000}, 30000), 70000u);
}

TEST(AdaptedBudget, KeepsBetweenItsBounds) {
  EXPECT_EQ(settled({100.0, 1.0, 1000000}, 500000), kLeastBudget);  // hopeless machine
  EXPECT_EQ(settled({0.1, 1e-6, 1000000}, 10000, 60000), 60000u);
  EXPECT_EQ(adapted_budget(0, {0.0, 0}, 30.0, 70000), 70000u);  // nothing was drawn yet
}

TEST(TimeForTrees, IsTheRestOfAFrameButNeverNothing) {
  EXPECT_EQ(time_for_trees(40.0, 5.0), 35.0);
  EXPECT_EQ(time_for_trees(40.0, 400.0), 200.0);
}

TEST(StillBudget, SpendsWhatAStillPictureMayTake) {
  EXPECT_EQ(still_budget(20000, {10.0, 20000}, 50.0, 0), 100000u);
  EXPECT_EQ(still_budget(20000, {10.0, 20000}, 5000.0, 0), 160000u);  // eight times at most
  EXPECT_EQ(still_budget(20000, {10.0, 20000}, 50.0, 80000), 80000u);
  EXPECT_EQ(still_budget(20000, {10.0, 20000}, 0.0, 300000), 300000u);
}

TEST(StillBudget, EndsWhereNothingIsToBeGained) {
  EXPECT_FALSE(still_budget(20000, {40.0, 20000}, 50.0, 0));
  EXPECT_FALSE(still_budget(80000, {1.0, 80000}, 50.0, 80000));
  std::uint64_t budget = 2000;
  int pictures = 0;
  while (const auto next = still_budget(budget, {double(budget) / 1000.0, budget}, 500.0, 0)) {
    budget = *next;
    ASSERT_LT(++pictures, 10);
  }
  EXPECT_GT(budget, 300000u);
}

}  // namespace
}  // namespace bosk
