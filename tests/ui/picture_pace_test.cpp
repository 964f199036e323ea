#include "ui/picture_pace.h"

#include <gtest/gtest.h>

namespace bosk {
namespace {

// A machine that draws a billboard in `ms_each` and never all that is asked for.
struct Drawer {
  double ms_each = 0.001;
  int drawn = 0;
  std::uint64_t last_budget = 0;

  DrawWithBudget draw() {
    return [this](const PictureKey&, std::uint64_t budget) {
      ++drawn;
      last_budget = budget;
      FrameFigures figures;
      figures.budget = budget;
      figures.billboards = budget;
      figures.trees_ms = ms_each * double(budget);
      figures.detail = 0.5;
      return figures;
    };
  }
};

PictureKey key_at(double east) {
  ViewCamera camera;
  camera.eye.x = east;
  return picture_key(camera, {640, 480}, ViewOptions{}, 0.0);
}

TEST(PicturePace, DrawsOnlyWhenSomethingChanged) {
  PicturePace pace;
  Drawer drawer;
  EXPECT_TRUE(draw_when_changed(pace, key_at(0), {}, drawer.draw()));
  EXPECT_FALSE(draw_when_changed(pace, key_at(0), {}, drawer.draw()));
  EXPECT_TRUE(draw_when_changed(pace, key_at(1), {}, drawer.draw()));
  EXPECT_EQ(drawer.drawn, 2);
}

TEST(PicturePace, TimeCountsOnlyInWind) {
  ViewOptions options;
  EXPECT_EQ(picture_key({}, {64, 64}, options, 1.0), picture_key({}, {64, 64}, options, 2.0));
  options.wind_m = 0.1;
  EXPECT_NE(picture_key({}, {64, 64}, options, 1.0), picture_key({}, {64, 64}, options, 2.0));
}

TEST(PicturePace, MovingPicturesComeToTakeTheTimeAllowed) {
  PicturePace pace;
  Drawer drawer{.ms_each = 0.01};  // 20,000 billboards would take 200 ms
  ViewOptions options;
  options.frame_ms = 50.0;
  for (int i = 0; i < 20; ++i) draw_when_changed(pace, key_at(i), options, drawer.draw());
  // The budget is left alone within a tenth of the aim
  EXPECT_NEAR(pace.figures.trees_ms, 50.0, 5.0);
}

TEST(PicturePace, SlowDriversDrawSmallerPicturesWhileMoving) {
  EXPECT_EQ(share_while_moving(20.0, 25.0), 1.0);
  EXPECT_EQ(share_while_moving(150.0, 25.0), 0.5);
  EXPECT_EQ(share_while_moving(600.0, 25.0), 0.25);
  EXPECT_EQ(share_while_moving(600.0, 0.0), 1.0) << "no time was asked for";
}

TEST(PicturePace, TheCostOfAWholePictureGrowsWithItsPixels) {
  PicturePace pace;
  EXPECT_EQ(whole_picture_ms(pace, {640, 480}), 0.0) << "nothing was drawn yet";
  pace.drawn = key_at(0);
  pace.drawn->size_px = {320, 240};
  pace.figures.picture_ms = 10.0;
  EXPECT_DOUBLE_EQ(whole_picture_ms(pace, {640, 480}), 40.0);
}

TEST(PicturePace, AtRestABetterPictureIsDrawnOnce) {
  PicturePace pace;
  Drawer drawer{.ms_each = 0.01};
  ViewOptions options;
  options.frame_ms = 50.0;
  options.still_ms = 300.0;
  for (int i = 0; i < 20; ++i) draw_when_changed(pace, key_at(i), options, drawer.draw());
  const std::uint64_t moving = drawer.last_budget;
  EXPECT_TRUE(refine_at_rest(pace, options, drawer.draw()));
  EXPECT_GT(drawer.last_budget, 4 * moving);
  EXPECT_FALSE(refine_at_rest(pace, options, drawer.draw())) << "there is nothing better to be had";
}

}  // namespace
}  // namespace bosk
