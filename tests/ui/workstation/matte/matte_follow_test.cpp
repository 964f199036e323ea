#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/workstation/matte_hand.h"
#include "ui/workstation/matte/matte_step.h"

namespace bosk {
namespace {

using testing::HasSubstr;

// Mattes that follow what is drawn.
class MatteFollow : public MatteHand {};

TEST_F(MatteFollow, ALiveMatteFollowsTheStrokes) {
  paint({44, 60}, {52, 60});
  hand.settle();
  const MatteCanvas& canvas = workspace.matte.canvas;
  EXPECT_TRUE(canvas.live.matte.rgba.empty());
  EXPECT_THAT(canvas.live.what_is_missing, HasSubstr("background"));
  hand.key('X');
  paint({10, 10}, {80, 10});
  hand.settle();
  ASSERT_FALSE(canvas.live.matte.rgba.empty());
  const Image<glm::vec4>* matte = nullptr;
  EXPECT_EQ(shown_matte(workspace, matte), ShownMatte::live);
  EXPECT_GT(canvas.live.matte.rgba(48, 60).a, 0.9f);
  EXPECT_LT(canvas.live.matte.rgba(10, 10).a, 0.1f);
  hand.key('Z', true);
  hand.settle();
  EXPECT_TRUE(canvas.live.matte.rgba.empty());
}

TEST_F(MatteFollow, ALiveMatteFollowsTheOptions) {
  paint_both();
  hand.settle();
  const auto before = workspace.matte.canvas.live_revision;
  edit(workspace, option_edit(workspace.project(), "matte.opaque_above", "0.7"));
  hand.settle();
  EXPECT_GT(workspace.matte.canvas.live_revision, before);
}

TEST_F(MatteFollow, MatteAllPhotosShowsTheFullMatte) {
  EXPECT_TRUE(hand.is_enabled("matte/run"));  // without strokes the tree is guessed
  paint_both();
  hand.settle();
  hand.click("matte/run");
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(state_of(workspace, "matte"), StageState::current);
  const Image<glm::vec4>* matte = nullptr;
  EXPECT_EQ(shown_matte(workspace, matte), ShownMatte::full);
  EXPECT_FALSE(hand.is_enabled("matte/run"));  // nothing changed since
  paint({30, 20}, {60, 20});
  hand.settle();
  EXPECT_EQ(shown_matte(workspace, matte), ShownMatte::live);
  open("003");
  EXPECT_EQ(shown_matte(workspace, matte), ShownMatte::outdated);
}

TEST_F(MatteFollow, ApplyingToTheOthersLeadsToAllPhotosMostInDoubtFirst) {
  paint_both();
  hand.settle();
  hand.click("matte/apply");
  ASSERT_TRUE(hand.settle());
  ASSERT_TRUE(workspace.matte.sheet);
  const MatteReview& review = workspace.matte.review;
  ASSERT_EQ(review.doubts.size(), 6u);
  const auto names = photos_in_order(review, true);
  for (std::size_t i = 1; i < names.size(); ++i) {
    EXPECT_GE(review.doubts.at(names[i - 1]).doubt, review.doubts.at(names[i]).doubt);
  }
  hand.click("matte/sheet/" + names[1]);
  hand.settle();
  EXPECT_FALSE(workspace.matte.sheet);
  EXPECT_EQ(workspace.matte.canvas.photo, names[1]);
}

TEST_F(MatteFollow, SShowsAllPhotosInThePresentView) {
  hand.key('S');
  hand.frame(2);
  for (const char* name : {"000", "001", "002"}) {
    EXPECT_TRUE(hand.sees(std::string("matte/sheet/") + name)) << name;
  }
  hand.key('S');
  hand.frame();
  EXPECT_TRUE(hand.sees("matte/canvas"));
}

TEST_F(MatteFollow, KeepingUpMattesAllPhotosAfterAStroke) {
  hand.click("matte/keep_up");
  paint_both();
  EXPECT_TRUE(
      hand.wait_for([&] { return state_of(workspace, "matte") == StageState::current; }, 60.0));
}

TEST_F(MatteFollow, StrokesOfOneKindStopNothing) {
  hand.click("matte/keep_up");
  paint({44, 60}, {52, 60});
  hand.settle();
  EXPECT_NE(state_of(workspace, "matte"), StageState::current);
  EXPECT_TRUE(workspace.jobs.records().empty() ||
              workspace.jobs.records().back().end != JobRecord::End::failed);
}

TEST_F(MatteFollow, StrokesOfAnotherPhotoStayThere) {
  paint({44, 60}, {52, 60});
  open("002");
  EXPECT_EQ(std::count(workspace.matte.canvas.strokes.pixels().begin(),
                       workspace.matte.canvas.strokes.pixels().end(), kForegroundStroke),
            0);
  paint({10, 10}, {80, 10});
  EXPECT_EQ(strokes_of("000").size(), 1u);
  EXPECT_EQ(strokes_of("002").size(), 1u);
  open("000");
  expect_canvas_is_the_projects();
}

TEST_F(MatteFollow, ADroppedFolderOfMattesBecomesTheProjectsInOneEdit) {
  const auto mattes = scratch.path() / "capture" / "mattes";
  hand.drop({mattes});
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(workspace.step, WorkStep::matte);
  EXPECT_EQ(workspace.project().photos.size(), 6u);
  EXPECT_EQ(workspace.project().absolute(workspace.project().mattes), mattes);
  ASSERT_EQ(workspace.matte.said.size(), 1u);
  EXPECT_THAT(workspace.matte.said[0].text, HasSubstr("6 of 6 photos"));
  ASSERT_TRUE(workspace.capture);
  EXPECT_EQ(workspace.capture->mattes.size(), 6u);
  hand.key('Z', true);
  EXPECT_TRUE(workspace.project().mattes.empty());
}

TEST_F(MatteFollow, ADroppedFolderOfPicturesThatAreNoMattesIsToldAndChangesNothing) {
  const auto pictures = scratch.path() / "pictures";
  std::filesystem::copy(scratch.path() / "capture" / "photos", pictures);
  hand.drop({pictures});
  ASSERT_TRUE(hand.settle());
  EXPECT_TRUE(workspace.project().mattes.empty());
  EXPECT_EQ(workspace.project().photos.size(), 6u);
  ASSERT_EQ(workspace.matte.said.size(), 1u);
  EXPECT_THAT(workspace.matte.said[0].text, HasSubstr("000"));
  EXPECT_EQ(workspace.matte.said[0].tone, Tone::bad);
}

TEST(MatteStepWithFinishedMattes, SaysThatStrokesAreNotUsed) {
  const ScratchFolder scratch;
  copy_matte_project(scratch.path());
  Hand hand;
  open_project(hand.workspace(), scratch.path() / "oak");
  edit(hand.workspace(), files_edit(hand.workspace().project(), FileKind::mattes,
                                    scratch.path() / "capture" / "mattes"));
  hand.workspace().step = WorkStep::matte;
  hand.settle();
  EXPECT_THAT(strokes_obstacle(hand.workspace()), HasSubstr("finished mattes"));
  const Landmark canvas = hand.at("matte/canvas");
  hand.drag(canvas.middle(), {canvas.middle().x + 50.0f, canvas.middle().y});
  EXPECT_TRUE(hand.workspace().project().strokes.empty());
}

}  // namespace
}  // namespace bosk
