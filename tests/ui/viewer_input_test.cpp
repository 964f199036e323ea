// A scripted hand at mouse and keyboard: Dear ImGui without a window, one frame for each change.

#include "ui/viewer_input.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

class ViewerInput : public testing::Test {
 protected:
  ViewerInput() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {800, 600};
    io.DisplayFramebufferScale = {1, 1};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    io.MousePos = {400, 500};
    state.camera = framing(scene, {800, 600}, view_angle(state.options));
    state.panel = false;
    frame();
  }
  ~ViewerInput() override { ImGui::DestroyContext(); }

  bool frame(std::vector<int> pressed = {}) {
    ImGui::GetIO().DeltaTime = 0.05f;
    ImGui::NewFrame();
    const bool moving = apply_input(state, scene, {800, 600}, pressed, 0.05);
    if (state.panel) {
      draw_look_panel(state);
      draw_figures_panel(state);
    }
    if (state.keys) draw_keys_panel(state);
    ImGui::Render();
    return moving;
  }
  // Pressed and released within one frame.
  void tap(int key) { frame({key}); }
  void move_to(float x, float y) {
    ImGui::GetIO().MousePos = {x, y};
    frame();
  }
  void hold(int button, bool down) {
    ImGui::GetIO().MouseDown[button] = down;
    frame();
  }

  ForestScene scene{{std::make_shared<const SceneTree>("ball", toy::random_ball(1))}, {{}}, {}};
  ViewerState state;
};

TEST_F(ViewerInput, DragOrbitsOnlyWhileTheButtonIsDown) {
  const ViewCamera start = state.camera;
  move_to(420, 500);
  EXPECT_EQ(state.camera, start);
  hold(0, true);
  move_to(520, 500);
  EXPECT_NE(state.camera.eye, start.eye);
  EXPECT_NEAR(state.camera.distance, start.distance, 1e-9);
  hold(0, false);
  const ViewCamera after = state.camera;
  move_to(300, 400);
  EXPECT_EQ(state.camera, after);
}

TEST_F(ViewerInput, RightDragPansAndTheWheelZooms) {
  const ViewCamera start = state.camera;
  hold(1, true);
  move_to(430, 500);
  hold(1, false);
  EXPECT_EQ(state.camera.heading, start.heading);
  EXPECT_NE(state.camera.eye.x, start.eye.x);
  ImGui::GetIO().MouseWheel = 1.0f;
  frame();
  EXPECT_LT(state.camera.distance, start.distance);
}

TEST_F(ViewerInput, KeysWalkFlyAndComeHome) {
  tap(GLFW_KEY_3);
  EXPECT_EQ(state.camera.mode, ViewCamera::Mode::walk);
  EXPECT_NEAR(state.camera.eye.z, kEyeHeight, 1e-9);
  const double y = state.camera.eye.y;
  ImGui::GetIO().KeysDown[GLFW_KEY_W] = true;
  EXPECT_TRUE(frame());
  ImGui::GetIO().KeysDown[GLFW_KEY_W] = false;
  EXPECT_FALSE(frame());
  EXPECT_NEAR(state.camera.eye.y, y + 0.05 * state.camera.speed, 1e-9);
  tap(GLFW_KEY_2);
  EXPECT_EQ(state.camera.mode, ViewCamera::Mode::fly);
  tap(GLFW_KEY_HOME);
  EXPECT_EQ(state.camera, framing(scene, {800, 600}, view_angle(state.options)));
}

TEST_F(ViewerInput, KeysSwitchColoursBlendMarksPanelsAndAskForPictures) {
  for (const char* colours : {"levels", "cells", "pruned", "tree"}) {
    tap(GLFW_KEY_C);
    EXPECT_EQ(state.options.colours, colours);
  }
  tap(GLFW_KEY_B);
  EXPECT_EQ(state.options.blend, "linear");
  tap(GLFW_KEY_V);
  EXPECT_TRUE(state.options.cameras);
  tap(GLFW_KEY_TAB);
  EXPECT_TRUE(state.panel);
  tap(GLFW_KEY_H);
  EXPECT_TRUE(state.keys);
  frame();  // all panels draw without a window
  tap(GLFW_KEY_P);
  EXPECT_TRUE(state.picture_wanted);
  tap(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(state.close_wanted);
}

TEST_F(ViewerInput, LeavesTheMouseToAPanelUnderIt) {
  state.panel = true;
  frame();
  move_to(700, 60);  // over the panel at the right
  frame();
  const ViewCamera start = state.camera;
  hold(0, true);
  move_to(705, 90);
  EXPECT_EQ(state.camera, start);
  hold(0, false);
}

TEST_F(ViewerInput, EveryOptionHasARangeAndHelp) {
  for (const Option& option : describe(state.options)) {
    EXPECT_FALSE(option.help.empty()) << option.name;
  }
}

}  // namespace
}  // namespace bosk
