// The tree live through OpenGL, without a window.

#include <gtest/gtest.h>

#include <memory>

#include "core/base/error.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/finished_project.h"
#include "tests/ui/workstation/gl_screen.h"
#include "ui/gl_tree_pictures.h"

namespace bosk {
namespace {

class LiveTreeGl : public testing::Test {
 protected:
  void SetUp() override {
    try {
      screen = std::make_unique<GlScreen>(760, 480);
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
    hand = std::make_unique<Hand>(ImVec2(760, 480), "", screen->screen());
    hand->workspace().tree_pictures = gl_tree_pictures("a driver");
    open_project(hand->workspace(), finished_project(scratch.path()).folder);
    hand->settle();
    hand->click("step/preview");
    hand->settle();
  }
  void TearDown() override { hand.reset(); }

  LiveTreeState& live() { return hand->workspace().preview.live; }
  // What of the frame shows the tree.
  std::vector<glm::u8vec3> tree_pixels() {
    const Landmark area = hand->at("preview/tree");
    const Image<glm::u8vec3> frame = screen->picture();
    std::vector<glm::u8vec3> pixels;
    for (int y = int(area.least.y) + 1; y < int(area.most.y) - 1; ++y) {
      for (int x = int(area.least.x) + 1; x < int(area.most.x) - 1; ++x) {
        pixels.push_back(frame(x, y));
      }
    }
    return pixels;
  }

  const ScratchFolder scratch;
  std::unique_ptr<GlScreen> screen;
  std::unique_ptr<Hand> hand;
};

TEST_F(LiveTreeGl, SkyIsAboveTheGround) {
  const std::vector<glm::u8vec3> pixels = tree_pixels();
  ASSERT_GT(live().pace.figures.billboards, 0u);
  EXPECT_TRUE(live().trouble.empty());
  EXPECT_GT(int(pixels.front().b), int(pixels.front().r)) << "blue";
  EXPECT_GE(int(pixels.back().g), int(pixels.back().b)) << "the ground isn't";
}

TEST_F(LiveTreeGl, NothingIsDrawnAnewWhileNothingChanges) {
  hand->frame(2);
  live().pace.figures.driver = "kept";  // a new picture would bring its own
  hand->frame(10);
  EXPECT_EQ(live().pace.figures.driver, "kept");
  const ImVec2 middle = hand->at("preview/tree").middle();
  hand->drag(middle, {middle.x + 50, middle.y});
  EXPECT_EQ(live().pace.figures.driver, "a driver");
}

TEST_F(LiveTreeGl, ASlowDriverDrawsFewerPixelsWhileTheHandMoves) {
  const glm::ivec2 whole = live().wanted.size_px;
  live().look.frame_ms = 1e-3;
  hand->move_to(hand->at("preview/tree").middle());
  hand->wheel(1.0f);
  EXPECT_EQ(live().texture.size_px, whole / 4);
  live().look.frame_ms = 1000.0;
  hand->wheel(1.0f);
  EXPECT_EQ(live().texture.size_px, whole);
}

TEST_F(LiveTreeGl, FalseColoursChangeThePicture) {
  const auto before = tree_pixels();
  live().look.colours = "levels";
  hand->frame(2);
  EXPECT_NE(tree_pixels(), before);
}

TEST_F(LiveTreeGl, AForestHasAsManyTreesAsAskedFor) {
  live().forest.trees = 25;
  live().forest.terrain_m = 2.0;
  hand->settle();
  EXPECT_EQ(live().pace.figures.instances, 25u);
}

}  // namespace
}  // namespace bosk
