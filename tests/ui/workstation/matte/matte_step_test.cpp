#include "ui/workstation/matte/matte_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/workstation/matte_hand.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/shortcuts.h"

namespace bosk {
namespace {

using testing::HasSubstr;

class MatteStep : public MatteHand {
 protected:
  // Two places with the button held.
  void begin_stroke() {
    hand.move_to(on_screen({30, 40}));
    hand.press();
    hand.move_to(on_screen({60, 40}));
  }
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
  begin_stroke();
  workspace.input.focus_lost = true;
  hand.frame();
  ASSERT_EQ(strokes_of("000").size(), 1u);
  hand.move_to(on_screen({60, 90}));  // the button is still down
  hand.release();
  EXPECT_EQ(strokes_of("000").size(), 1u);
  EXPECT_EQ(last_stroke().points_px.size(), 2u);
}

TEST_F(MatteStep, LeavingTheStepKeepsTheStrokeInHand) {
  begin_stroke();
  hand.key('4', true);
  EXPECT_EQ(workspace.step, WorkStep::volume);
  EXPECT_EQ(strokes_of("000").size(), 1u);
  hand.release();
}

TEST_F(MatteStep, GoingToAnotherPhotoKeepsTheStrokeInHandOnItsOwn) {
  begin_stroke();
  hand.key(kKeyPageDown);
  hand.release();
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(workspace.matte.canvas.photo, "001");
  EXPECT_EQ(strokes_of("000").size(), 1u);
  EXPECT_TRUE(strokes_of("001").empty());
}

TEST_F(MatteStep, ShowingTheSheetKeepsTheStrokeInHand) {
  begin_stroke();
  hand.key('S');
  ASSERT_EQ(strokes_of("000").size(), 1u);
  hand.release();
  hand.key('S');
  hand.frame(2);
  EXPECT_EQ(strokes_of("000").size(), 1u);
  EXPECT_EQ(last_stroke().points_px.size(), 2u);
}

TEST_F(MatteStep, ClosingKeepsTheStrokeInHand) {
  begin_stroke();
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

}  // namespace
}  // namespace bosk
