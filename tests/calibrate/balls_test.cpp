#include "core/calibrate/balls.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/base/random.h"
#include "meadow.h"

namespace bosk {
namespace {

const Progress kQuiet;
const glm::vec3 kRed(0.84f, 0.1f, 0.1f), kBlue(0.1f, 0.25f, 0.84f);

TEST(FindBalls, FindsBallsOfAnyColourToAFifthOfAPixel) {
  Image<glm::vec3> image = meadow(200, 160);
  draw_ball(image, {50.3, 60.6}, 7.2, kRed);
  draw_ball(image, {130.8, 80.1}, 11.0, kBlue);
  const auto balls = find_balls(image, {}, kQuiet);
  ASSERT_EQ(balls.size(), 2u);
  EXPECT_LT(glm::distance(balls[0].centre_px, {50.3, 60.6}), 0.2);
  EXPECT_LT(glm::distance(balls[1].centre_px, {130.8, 80.1}), 0.2);
  EXPECT_NEAR(balls[0].radius_px, 7.2, 0.4);
  EXPECT_GT(balls[0].visible, 0.9);
  EXPECT_LT(balls[0].sigma_px, 0.2);
}

TEST(FindBalls, KnowsTheCentreOfABallBehindLeavesAndDoubtsIt) {
  Image<glm::vec3> image = meadow(160, 120);
  draw_ball(image, {80.0, 60.0}, 10.0, kRed);
  const auto whole = find_balls(image, {}, kQuiet);
  draw_leaves(image, 76.0, 60, 40, 80);
  const auto hidden = find_balls(image, {}, kQuiet);
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_LT(glm::distance(hidden[0].centre_px, {80.0, 60.0}), 0.6);  // what shows centres at 83
  EXPECT_GT(hidden[0].sigma_px, 2.0 * whole[0].sigma_px);
  EXPECT_LT(hidden[0].visible, 0.85);
}

TEST(FindBalls, FindsNoneInGrassLeavesAndSky) {
  Image<glm::vec3> image = meadow(200, 160);
  draw_leaves(image, 120.0, 20, 20, 90);
  for (int y = 0; y < 15; ++y)
    for (int x = 0; x < 200; ++x) image(x, y) = {0.55f, 0.7f, 0.95f};
  Random random(3, 1);
  for (int gap = 0; gap < 30; ++gap) {  // sky through the leaves
    const int x = int(random.uniform(25, 110)), y = int(random.uniform(25, 80));
    for (int dy = 0; dy < 5; ++dy)
      for (int dx = 0; dx < 4 + dy % 3; ++dx) image(x + dx, y + dy) = {0.55f, 0.7f, 0.95f};
  }
  EXPECT_TRUE(find_balls(image, {}, kQuiet).empty());
}

TEST(FindBalls, FlowersOfOneColourAreNoBalls) {
  Image<glm::vec3> image = meadow(240, 200);
  for (int i = 0; i < 40; ++i)
    draw_ball(image, {15.0 + 30.0 * (i % 8), 20.0 + 35.0 * (i / 8)}, 5.0, kRed);
  EXPECT_TRUE(find_balls(image, {}, kQuiet).empty());
}

TEST(FindBalls, SeesTheFootOfTheStick) {
  Image<glm::vec3> image = meadow(160, 160);
  draw_stick(image, {80.2, 50.0}, 112.4);
  draw_ball(image, {80.2, 50.0}, 8.0, kBlue);
  const auto balls = find_balls(image, {}, kQuiet);
  ASSERT_EQ(balls.size(), 1u);
  ASSERT_TRUE(balls[0].foot);
  EXPECT_NEAR(balls[0].foot->pixel.x, 80.2, 0.7);
  EXPECT_NEAR(balls[0].foot->pixel.y, 112.4, 1.0);
}

TEST(FindBalls, SaysNothingOfAStickThatIsNotThere) {
  Image<glm::vec3> image = meadow(160, 160);
  draw_ball(image, {80.2, 50.0}, 8.0, kBlue);
  const auto balls = find_balls(image, {}, kQuiet);
  ASSERT_EQ(balls.size(), 1u);
  EXPECT_FALSE(balls[0].foot);
}

TEST(FindBalls, SameWithOneThreadAndMany) {
  Image<glm::vec3> image = meadow(200, 160);
  draw_ball(image, {50.3, 60.6}, 7.2, kRed);
  draw_ball(image, {130.8, 80.1}, 11.0, kBlue);
  const auto many = find_balls(image, {}, kQuiet);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = find_balls(image, {}, kQuiet);
  ASSERT_EQ(many.size(), single.size());
  for (std::size_t i = 0; i < many.size(); ++i) {
    EXPECT_EQ(many[i].centre_px, single[i].centre_px);
    EXPECT_EQ(many[i].sigma_px, single[i].sigma_px);
  }
}

TEST(FindBalls, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(find_balls(meadow(60, 60), {}, progress), Cancelled);
}

}  // namespace
}  // namespace bosk
