#include "ui/workstation/matte_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/image/orientation.h"
#include "core/matte/scribbles.h"
#include "tests/ui/workstation/matte_project.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/matte_paint.h"
#include "ui/workstation/shortcuts.h"

namespace bosk {
namespace {

using testing::HasSubstr;

class MatteStep : public testing::Test {
 protected:
  MatteStep() {
    copy_matte_project(scratch.path());
    open_project(workspace, scratch.path() / "oak");
    workspace.step = WorkStep::matte;
    EXPECT_TRUE(hand.settle());
    EXPECT_TRUE(hand.wait_for([&] { return photo_on_canvas(workspace) != nullptr; }, 60.0));
    hand.settle();
  }

  void open(const std::string& photo) {
    hand.click("matte/photo/" + photo);
    hand.settle();
  }

  // Where the upright picture lies on the screen now.
  ImagePlace place() {
    const Landmark canvas = hand.at("matte/canvas");
    const Photo& photo = *photo_on_canvas(workspace);
    const glm::ivec2 size =
        upright_size({photo.srgb.width(), photo.srgb.height()}, orientation_on_canvas(workspace));
    return place_of(workspace.matte.image_view, size, canvas.least, canvas.most);
  }
  ImVec2 on_screen(const glm::dvec2& upright_px) {
    const glm::dvec2 at = place().screen_from_picture(upright_px);
    return {float(at.x), float(at.y)};
  }
  void paint(const glm::dvec2& from, const glm::dvec2& to, int steps = 6) {
    hand.drag(on_screen(from), on_screen(to), steps);
  }
  // Over the crown and the sky of the tiny tree.
  void paint_both() {
    paint({44, 60}, {52, 60});
    hand.key('X');
    paint({10, 10}, {80, 10});
    hand.key('X');
  }

  const std::vector<Stroke>& strokes_of(const std::string& photo) {
    static const std::vector<Stroke> none;
    const auto found = workspace.project().strokes.find(photo);
    return found == workspace.project().strokes.end() ? none : found->second;
  }
  const Stroke& last_stroke() { return strokes_of(workspace.matte.photo).back(); }

  // To one pixel of the photo as taken: the mouse stands on whole points of the screen.
  void expect_at(const glm::dvec2& taken_px, const glm::dvec2& upright_px) {
    const Photo& photo = *photo_on_canvas(workspace);
    const auto wanted = taken_from_upright(photo, orientation_on_canvas(workspace), upright_px);
    ASSERT_TRUE(wanted);
    EXPECT_LT(glm::distance(taken_px, *wanted), 1.0);
  }
  void expect_canvas_is_the_projects() {
    const MatteCanvas& canvas = workspace.matte.canvas;
    Image<std::uint8_t> wanted(canvas.strokes.width(), canvas.strokes.height(), kNoStroke);
    paint_strokes(strokes_of(canvas.photo), *photo_on_canvas(workspace), wanted);
    EXPECT_EQ(canvas.strokes, wanted);
  }
  const Image<glm::u8vec4>& seen() {
    const Texture texture = workspace.pictures.newest("matte/" + workspace.matte.photo);
    return hand.textures().pictures.at(texture.id);
  }

  const ScratchFolder scratch;
  Hand hand;
  Workspace& workspace = hand.workspace();
};

TEST_F(MatteStep, ReadsThePhotosByItself) {
  EXPECT_EQ(state_of(workspace, "photo"), StageState::current);
  EXPECT_EQ(workspace.matte.photo, "000");
  for (const char* name : {"000", "001", "005"}) {
    EXPECT_TRUE(hand.sees(std::string("matte/photo/") + name)) << name;
  }
}

TEST_F(MatteStep, AStrokeIsWhereTheMouseWas) {
  paint({30, 40}, {60, 90});
  ASSERT_EQ(strokes_of("000").size(), 1u);
  const Stroke& stroke = last_stroke();
  EXPECT_EQ(stroke.kind, StrokeKind::foreground);
  EXPECT_NEAR(stroke.radius_px, 10.0, 0.1);
  ASSERT_EQ(stroke.points_px.size(), 7u);
  for (int i = 0; i <= 6; ++i) {
    expect_at(stroke.points_px[std::size_t(i)],
              glm::mix(glm::dvec2(30, 40), glm::dvec2(60, 90), i / 6.0));
  }
  expect_canvas_is_the_projects();
}

TEST_F(MatteStep, AClickIsADisc) {
  hand.click_at(on_screen({48, 64}));
  ASSERT_EQ(strokes_of("000").size(), 1u);
  EXPECT_EQ(last_stroke().points_px.size(), 1u);
  expect_at(last_stroke().points_px.front(), {48, 64});
}

TEST_F(MatteStep, AStrokeIsSeenInTheFrameThatHearsIt) {
  hand.move_to(on_screen({48, 64}));
  const glm::u8vec4 before = seen()(48, 64);
  hand.press();
  EXPECT_NE(seen()(48, 64), before);
  EXPECT_TRUE(strokes_of("000").empty());  // not an edit before the button is let go
  const glm::u8vec4 further = seen()(70, 64);
  hand.move_to(on_screen({70, 64}));
  EXPECT_NE(seen()(70, 64), further);
  hand.release();
  EXPECT_EQ(strokes_of("000").size(), 1u);
}

TEST_F(MatteStep, AFrameThatIsSlowLosesNoPartOfAStroke) {
  const std::vector<glm::dvec2> path{{20, 20}, {30, 40}, {40, 60}, {50, 60}, {70, 100}};
  for (const glm::dvec2& at : path) workspace.input.mouse_path.push_back(on_screen(at));
  workspace.input.pressed_at = 1;
  workspace.input.released_at = 3;
  ImGui::GetIO().MousePos = on_screen(path.back());
  ImGui::GetIO().MouseDown[0] = true;  // as the window's library keeps a short press for a frame
  hand.frame();
  ImGui::GetIO().MouseDown[0] = false;
  hand.frame();
  ASSERT_EQ(strokes_of("000").size(), 1u);
  const auto& points = last_stroke().points_px;
  ASSERT_EQ(points.size(), 3u);
  expect_at(points[0], path[1]);
  expect_at(points[1], path[2]);
  expect_at(points[2], path[3]);
}

TEST_F(MatteStep, AltFlipsTreeAndBackgroundWhileItIsHeld) {
  hand.hold_modifiers(false, false, true);
  paint({20, 20}, {40, 20});
  EXPECT_EQ(last_stroke().kind, StrokeKind::background);
  EXPECT_NEAR(last_stroke().radius_px, workspace.matte.brush.radius_of(MatteTool::background), 0.1);
  hand.hold_modifiers(false, false, false);
  paint({20, 40}, {40, 40});
  EXPECT_EQ(last_stroke().kind, StrokeKind::foreground);
}

TEST_F(MatteStep, XSwapsAndEErasesAndComesBack) {
  hand.key('X');
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::background);
  hand.key('E');
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::eraser);
  hand.key('E');
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::background);
  hand.key('X');
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::tree);
}

TEST_F(MatteStep, TheEraserTakesStrokesAway) {
  paint({30, 60}, {60, 60});
  hand.key('E');
  paint({30, 60}, {60, 60});
  EXPECT_EQ(last_stroke().kind, StrokeKind::erase);
  EXPECT_EQ(workspace.matte.canvas.strokes(45, 60), kNoStroke);
  expect_canvas_is_the_projects();
}

TEST_F(MatteStep, ToolsAreChosenByTheirButtonsToo) {
  hand.click("matte/background");
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::background);
  hand.click("matte/eraser");
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::eraser);
  hand.click("matte/tree");
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::tree);
}

TEST_F(MatteStep, BracketsChangeTheSizeOfTheToolInHandAlone) {
  const MatteBrush before = workspace.matte.brush;
  hand.key(kKeyRightBracket);
  EXPECT_NEAR(workspace.matte.brush.radius_of(MatteTool::tree), 11.0, 1e-9);
  hand.key(kKeyLeftBracket, false, true);
  EXPECT_NEAR(workspace.matte.brush.radius_of(MatteTool::tree), 11.0 / 1.5, 1e-9);
  EXPECT_EQ(workspace.matte.brush.radius_of(MatteTool::background),
            before.radius_of(MatteTool::background));
  for (int i = 0; i < 30; ++i) workspace.input.keys.push_back(kKeyLeftBracket);  // held down
  hand.frame();
  EXPECT_NEAR(workspace.matte.brush.radius_of(MatteTool::tree), kLeastBrushPx, 1e-9);
}

TEST_F(MatteStep, ARightDragResizesTheBrushAndPaintsNothing) {
  const ImVec2 at = on_screen({48, 64});
  hand.drag(at, {at.x + 80.0f, at.y + 30.0f}, 8, 1);
  EXPECT_NEAR(workspace.matte.brush.radius_of(MatteTool::tree), 20.0, 1e-6);
  hand.drag(at, {at.x - 80.0f, at.y}, 8, 1);
  EXPECT_NEAR(workspace.matte.brush.radius_of(MatteTool::tree), 10.0, 1e-6);
  EXPECT_TRUE(strokes_of("000").empty());
}

TEST_F(MatteStep, FGoesThroughAllViews) {
  for (int i = 1; i <= kMatteViews; ++i) {
    hand.key('F');
    EXPECT_EQ(int(workspace.matte.view), i % kMatteViews);
  }
}

TEST_F(MatteStep, PageKeysLeadThroughThePhotos) {
  hand.key(kKeyPageDown);
  EXPECT_EQ(workspace.matte.photo, "001");
  hand.key(kKeyPageUp);
  hand.key(kKeyPageUp);
  EXPECT_EQ(workspace.matte.photo, "000");
}

TEST_F(MatteStep, EveryKeyIsInTheList) {
  std::string listed;
  for (const Shortcut& shortcut : shortcuts()) {
    if (shortcut.where == "Matte") listed += shortcut.keys + ", ";
  }
  for (const char* key : {"Alt", "X", "E", "[ and ]", "right drag", "F", "S", "Page Down"}) {
    EXPECT_THAT(listed, HasSubstr(key));
  }
}

TEST_F(MatteStep, KeysTypedIntoAFieldAreNotHeard) {
  ImGui::GetIO().WantTextInput = true;
  workspace.input.keys = {'X', 'F', 'E'};
  hear_matte_keys(workspace);
  EXPECT_EQ(workspace.matte.brush.tool, MatteTool::tree);
  EXPECT_EQ(workspace.matte.view, MatteView::photo);
}

TEST_F(MatteStep, UndoAndRedoGoStrokeByStroke) {
  paint({30, 40}, {60, 40});
  paint({30, 44}, {60, 80});
  const Image<std::uint8_t> both = workspace.matte.canvas.strokes;
  hand.key('Z', true);
  EXPECT_EQ(strokes_of("000").size(), 1u);
  expect_canvas_is_the_projects();
  hand.key('Z', true);
  EXPECT_TRUE(strokes_of("000").empty());
  expect_canvas_is_the_projects();
  hand.key('Z', true, true);
  hand.key('Y', true);
  EXPECT_EQ(strokes_of("000").size(), 2u);
  EXPECT_EQ(workspace.matte.canvas.strokes, both);
}

TEST_F(MatteStep, RemovingAllStrokesIsOneUndoableStep) {
  EXPECT_FALSE(hand.is_enabled("matte/clear"));
  paint({30, 40}, {60, 40});
  paint({30, 44}, {60, 80});
  hand.click("matte/clear");
  EXPECT_TRUE(strokes_of("000").empty());
  expect_canvas_is_the_projects();
  hand.key('Z', true);
  EXPECT_EQ(strokes_of("000").size(), 2u);
  expect_canvas_is_the_projects();
}

TEST_F(MatteStep, LosingTheKeyboardKeepsTheStrokeInHand) {
  hand.move_to(on_screen({30, 40}));
  hand.press();
  hand.move_to(on_screen({60, 40}));
  workspace.input.focus_lost = true;
  hand.frame();
  ASSERT_EQ(strokes_of("000").size(), 1u);
  hand.move_to(on_screen({60, 90}));  // the button is still down
  hand.release();
  EXPECT_EQ(strokes_of("000").size(), 1u);
  EXPECT_EQ(last_stroke().points_px.size(), 2u);
}

TEST_F(MatteStep, LeavingTheStepKeepsTheStrokeInHand) {
  hand.move_to(on_screen({30, 40}));
  hand.press();
  hand.move_to(on_screen({60, 40}));
  hand.key('4', true);
  EXPECT_EQ(workspace.step, WorkStep::volume);
  EXPECT_EQ(strokes_of("000").size(), 1u);
  hand.release();
}

TEST_F(MatteStep, ClosingKeepsTheStrokeInHand) {
  hand.move_to(on_screen({30, 40}));
  hand.press();
  hand.move_to(on_screen({60, 40}));
  close_project(workspace);
  const Project project = read_project(scratch.path() / "oak");
  ASSERT_EQ(project.strokes.count("000"), 1u);
  EXPECT_EQ(project.strokes.at("000").front().points_px.size(), 2u);
  hand.release();
}

TEST_F(MatteStep, ZoomedStrokesAreWhereTheMouseWas) {
  hand.move_to(on_screen({70, 30}));
  hand.wheel(6.0f);
  ASSERT_GT(workspace.matte.image_view.zoom, 3.0);
  paint({66, 28}, {72, 33});
  expect_at(last_stroke().points_px.front(), {66, 28});
  expect_at(last_stroke().points_px.back(), {72, 33});
  EXPECT_NEAR(last_stroke().radius_px, 10.0, 0.1);  // of the photo, whatever the zoom
  hand.key(kKeyHome);
  EXPECT_EQ(workspace.matte.image_view.zoom, 1.0);
}

TEST_F(MatteStep, SpaceAndTheMiddleButtonMoveThePhotoAndPaintNothing) {
  hand.move_to(on_screen({48, 64}));
  hand.wheel(6.0f);
  const ImageView before = workspace.matte.image_view;
  const ImVec2 at = on_screen({48, 64});
  hand.drag(at, {at.x + 40.0f, at.y}, 4, 2);
  EXPECT_NE(workspace.matte.image_view, before);
  hand.hold(kKeySpace, true);
  hand.drag({at.x + 40.0f, at.y}, at, 4);
  hand.hold(kKeySpace, false);
  EXPECT_NEAR(workspace.matte.image_view.middle.x, before.middle.x, 1e-6);
  EXPECT_TRUE(strokes_of("000").empty());
}

TEST_F(MatteStep, ATurnedPhotoIsShownUprightAndPaintedWhereTheMouseWas) {
  open("001");
  ASSERT_EQ(orientation_on_canvas(workspace), 6);
  const Photo& photo = *photo_on_canvas(workspace);
  ASSERT_LT(photo.srgb.width(), photo.srgb.height());  // as delivered
  EXPECT_GT(place().size_px.x, place().size_px.y);     // as shown
  paint({100, 20}, {120, 50});
  const auto& points = last_stroke().points_px;
  expect_at(points.front(), {100, 20});
  expect_at(points.back(), {120, 50});
  // Turned by a quarter clockwise: shown (u, v) was delivered at (v, height - 1 - u); the lens
  // bends the corners by less than 2 px
  EXPECT_LT(glm::distance(points.front(), glm::dvec2(20, photo.srgb.height() - 1 - 100)), 3.0);
  EXPECT_EQ(workspace.matte.canvas.strokes(20, photo.srgb.height() - 1 - 100), kForegroundStroke);
}

TEST_F(MatteStep, ALiveMatteFollowsTheStrokes) {
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

TEST_F(MatteStep, ALiveMatteFollowsTheOptions) {
  paint_both();
  hand.settle();
  const auto before = workspace.matte.canvas.live_revision;
  edit(workspace, option_edit(workspace.project(), "matte.opaque_above", "0.7"));
  hand.settle();
  EXPECT_GT(workspace.matte.canvas.live_revision, before);
}

TEST_F(MatteStep, MatteAllPhotosShowsTheFullMatte) {
  EXPECT_FALSE(hand.is_enabled("matte/run"));  // no strokes
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

TEST_F(MatteStep, ApplyingToTheOthersLeadsToAllPhotosMostInDoubtFirst) {
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

TEST_F(MatteStep, SShowsAllPhotosInThePresentView) {
  hand.key('S');
  hand.frame(2);
  for (const char* name : {"000", "001", "002"}) {
    EXPECT_TRUE(hand.sees(std::string("matte/sheet/") + name)) << name;
  }
  hand.key('S');
  hand.frame();
  EXPECT_TRUE(hand.sees("matte/canvas"));
}

TEST_F(MatteStep, KeepingUpMattesAllPhotosAfterAStroke) {
  hand.click("matte/keep_up");
  paint_both();
  EXPECT_TRUE(
      hand.wait_for([&] { return state_of(workspace, "matte") == StageState::current; }, 60.0));
}

TEST_F(MatteStep, StrokesOfOneKindStopNothing) {
  hand.click("matte/keep_up");
  paint({44, 60}, {52, 60});
  hand.settle();
  EXPECT_NE(state_of(workspace, "matte"), StageState::current);
  EXPECT_TRUE(workspace.jobs.records().empty() ||
              workspace.jobs.records().back().end != JobRecord::End::failed);
}

TEST_F(MatteStep, StrokesOfAnotherPhotoStayThere) {
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
