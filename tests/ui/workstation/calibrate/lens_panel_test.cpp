#include "core/calibrate/lens_profile.h"
#include "tests/calibrate/board_phantom.h"
#include "tests/ui/workstation/calibrate/solved_hand.h"

namespace bosk {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

// Photos of a chessboard beside two of the tree: a lens, but no cameras.
class LensPanel : public testing::Test {
 protected:
  static const Phantom& phantom() {
    static const Phantom once = [] {
      Progress quiet;
      Phantom phantom = make_phantom(small_board_photos(2), quiet);
      write_phantom(scratch().path() / "capture", phantom, quiet);
      return phantom;
    }();
    return once;
  }
  static const ScratchFolder& scratch() {
    static const ScratchFolder folder;
    return folder;
  }
  void open() {
    const Board& board = phantom().board;
    NewProject wanted;
    wanted.folder = place;
    wanted.photos = {scratch() / "capture" / "photos"};
    Project project = make_project(wanted, Recipe(), true, Progress());
    set_option(project.recipe, "calibrate.features", "off");
    set_option(project.recipe, "calibrate.find_balls", "false");
    set_option(project.recipe, "calibrate.board", "chessboard");
    set_option(project.recipe, "calibrate.board_columns", std::to_string(board.columns - 1));
    set_option(project.recipe, "calibrate.board_rows", std::to_string(board.rows - 1));
    save_project(project);
    open_project(hand.workspace(), place);
    hand.workspace().step = WorkStep::calibrate;
    ASSERT_TRUE(hand.settle());
  }
  void type_into(const std::string& field, const std::string& text) {
    hand.click(field);
    hand.key('A', true);
    hand.type(text);
  }
  CalibrateStepState& state() { return hand.workspace().calibrate; }

  const fs::path place = scratch() / testing::UnitTest::GetInstance()->current_test_info()->name();
  Hand hand{ImVec2(1600, 1500)};
};

TEST_F(LensPanel, CalibratesFromAFolderOfBoardsShowsItAndSavesIt) {
  open();
  hand.click("calibrate/lens");
  hand.frame();
  type_into("calibrate/boards", (scratch() / "capture" / "board").string());
  hand.click("calibrate/take_boards");
  hand.click("calibrate/find");
  ASSERT_TRUE(hand.settle());
  ASSERT_TRUE(state().solved.finds && state().solved.finds->boards) << state().solved.trouble;
  hand.click("calibrate/show/lens");
  hand.frame();
  EXPECT_TRUE(hand.sees("calibrate/coverage"));
  EXPECT_TRUE(hand.sees("calibrate/uncertainty"));

  const fs::path file = place / "lens.json";
  type_into("calibrate/profile_place", file.string());
  hand.click("calibrate/save_profile");
  ASSERT_TRUE(hand.settle());
  ASSERT_FALSE(state().said.empty());
  EXPECT_THAT(state().said.front().text, HasSubstr("Saved the lens"));
  const LensProfile saved = read_lens_profile(file);
  const Lens& truth = phantom().board_photos.front().camera.lens;
  EXPECT_NEAR(saved.lens.focal_px.x / truth.focal_px.x, 1.0, 0.01);

  // The saved profile takes the boards' place
  hand.click("calibrate/take_boards/none");
  type_into("calibrate/profile", file.string());
  hand.click("calibrate/take_profile");
  hand.click("calibrate/find");
  ASSERT_TRUE(hand.settle());
  ASSERT_TRUE(state().solved.finds) << state().solved.trouble;
  EXPECT_TRUE(state().solved.finds->lens.known);
  EXPECT_EQ(state().solved.finds->lens.lens.focal_px, saved.lens.focal_px);
}

TEST_F(LensPanel, SaysWhatBoardsWouldGiveWhereThereAreNone) {
  open();
  hand.click("calibrate/show/lens");
  hand.frame();
  EXPECT_FALSE(hand.sees("calibrate/coverage"));
  EXPECT_FALSE(hand.sees("calibrate/save_profile"));
}

}  // namespace
}  // namespace bosk
