#include "ui/workstation/textures/textures_step.h"

#include <gtest/gtest.h>

#include "core/compress/texture_sheets.h"
#include "tests/ui/workstation/phantom_project.h"

namespace bosk {
namespace {

class TexturesStep : public PhantomStep {
 protected:
  TexturesStep() : PhantomStep("textures") {}
  const TexturesStepState& state() { return hand.workspace().textures; }
  const Billboards& billboards() { return *hand.workspace().results.billboards; }
  void bake() {
    hand.click("textures/run");
    ASSERT_TRUE(hand.settle());
    ASSERT_TRUE(hand.workspace().results.billboards);
  }
};

TEST_F(TexturesStep, ListsEveryLevelAndOpensAtTheFinestWithSeveralViews) {
  bake();
  ASSERT_EQ(state().rows.size(), billboards().levels.size());
  for (std::size_t i = 0; i < state().rows.size(); ++i) {
    EXPECT_EQ(state().rows[i].statistics.cells, billboards().levels[i].cells.size());
    EXPECT_TRUE(hand.sees("textures/level_" + std::to_string(billboards().levels[i].level)));
  }
  EXPECT_EQ(state().level, chosen_level(billboards()));
  EXPECT_GT(billboards().levels[std::size_t(state().level)].views.size(), 1u);
}

TEST_F(TexturesStep, ALevelIsChosenInTheTable) {
  bake();
  const int level = billboards().levels[1].level;
  hand.click("textures/level_" + std::to_string(level));
  hand.frame();
  EXPECT_EQ(state().level, 1);
  EXPECT_EQ(state().cell, int(fullest_cell(billboards().levels[1])));
}

TEST_F(TexturesStep, RowsOfATreeWithMoreLevelsGoWithIt) {
  bake();
  ASSERT_GT(billboards().levels.size(), 2u);
  auto fewer = std::make_shared<Billboards>(billboards());
  fewer->levels.resize(2);
  hand.workspace().results.billboards = fewer;
  hand.frame();
  EXPECT_LE(state().rows.size(), 2u);  // else a press on another asks for a level that isn't there
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state().rows.size(), 2u);
}

TEST_F(TexturesStep, ACellIsChosenByPressingItOnTheSheet) {
  bake();
  const Landmark sheet = hand.at("textures/sheet");
  const BillboardLevel& level = billboards().levels[std::size_t(state().level)];
  ASSERT_GT(level.cells.size() % 768, 40u);    // on every page
  const int first = state().cell / 768 * 768;  // of the page
  const TileSheet tiles =
      view_textures(billboards(), std::size_t(state().level), 0, std::size_t(first), 768, 32);
  const ImagePlace place = place_of({}, glm::dvec2(tiles.picture.width(), tiles.picture.height()),
                                    sheet.least, sheet.most);
  const glm::dvec2 at = place.screen_from_picture(glm::dvec2(tiles.corner_px(37)) + 1.0);
  hand.click_at({float(at.x), float(at.y)});
  EXPECT_EQ(state().cell, first + 37);
}

TEST_F(TexturesStep, ShowsOriginalBesideCompressedOnceThereAreCodebooks) {
  bake();
  EXPECT_TRUE(hand.sees("textures/baked"));
  EXPECT_FALSE(hand.sees("textures/coded"));
  run_to(hand.workspace(), "compress");
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(hand.sees("textures/coded"));
}

TEST_F(TexturesStep, CodebooksOfOtherTexturesAreNotShownBesideThem) {
  run_to(hand.workspace(), "compress");
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(hand.sees("textures/coded"));
  edit(hand.workspace(), option_edit(hand.workspace().project(), "texture.views", "6"));
  hand.frame(2);
  hand.click("textures/run");
  ASSERT_TRUE(hand.settle());
  EXPECT_FALSE(hand.sees("textures/coded"));
}

TEST_F(TexturesStep, BytesInThePackageAreTheFilesOwn) {
  run_to(hand.workspace(), "pack");
  ASSERT_TRUE(hand.settle());
  std::size_t packed = 0;
  for (const LevelRow& row : state().rows) packed += row.packed_bytes;
  EXPECT_GT(packed, 0u);
  EXPECT_LT(packed, hand.workspace().results.package->size());
}

}  // namespace
}  // namespace bosk
