#include "core/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace bosk {
namespace {

TEST(Random, IsTheSameEverywhere) {
  Random random(1, 2);
  // Drawn once on x86-64; any change here changes every phantom and every codebook
  EXPECT_EQ(random.bits(), 0xf5ee812611c36aaf);
  EXPECT_EQ(random.normal(), 0x1.c327b64d8990cp-2);
}

TEST(Random, StreamsAndSeedsDiffer) {
  EXPECT_NE(Random(1, 0).bits(), Random(1, 1).bits());
  EXPECT_NE(Random(1, 0).bits(), Random(2, 0).bits());
  EXPECT_NE(Random(0, 1).bits(), Random(1, 0).bits());
}

TEST(Random, UniformFillsItsRangeEvenly) {
  constexpr int kDraws = 100'000;
  Random random(3);
  std::array<int, 10> bins{};
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.uniform(-2.0, 3.0);
    ASSERT_GE(value, -2.0);
    ASSERT_LT(value, 3.0);
    ++bins[std::size_t((value + 2.0) * 2.0)];
  }
  // A bin's count has a standard deviation of 95; 5 of them
  for (const int count : bins) EXPECT_NEAR(count, kDraws / 10.0, 475);
}

TEST(Random, BelowReachesEachNumberEvenly) {
  Random random(4);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70'000; ++i) ++counts.at(random.below(7));
  // Standard deviation 93; 5 of them
  for (const int count : counts) EXPECT_NEAR(count, 10'000, 465);
}

TEST(Random, NormalHasTheMomentsAndTailsOfANormal) {
  constexpr int kDraws = 200'000;
  Random random(5);
  double sum = 0.0, squares = 0.0, fourths = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
    fourths += std::pow(value, 4);
    if (std::abs(value) > 2.0) ++beyond_two;
  }
  // 5 standard deviations of each estimate: sqrt(1/n), sqrt(2/n), sqrt(96/n), sqrt(p(1-p)/n)
  EXPECT_NEAR(sum / kDraws, 0.0, 0.012);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.016);
  EXPECT_NEAR(fourths / kDraws, 3.0, 0.11);
  EXPECT_NEAR(double(beyond_two) / kDraws, 0.0455, 0.0024);
}

}  // namespace
}  // namespace bosk
