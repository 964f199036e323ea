#include "ui/viewer_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "ui/widgets/camera_mouse.h"

namespace bosk {
namespace {

Strides strides_held() {
  const auto axis = [](int plus, int minus) {
    return double(ImGui::IsKeyDown(plus)) - double(ImGui::IsKeyDown(minus));
  };
  Strides strides;
  strides.forward = axis(GLFW_KEY_W, GLFW_KEY_S);
  strides.right = axis(GLFW_KEY_D, GLFW_KEY_A);
  strides.up = axis(GLFW_KEY_E, GLFW_KEY_Q);
  strides.fast = ImGui::GetIO().KeyShift;
  return strides;
}

// Keys pressed since the last frame.
struct Presses {
  std::span<const int> keys;

  bool operator()(int key) const { return std::find(keys.begin(), keys.end(), key) != keys.end(); }
};

std::string next_choice(const std::string& now, std::initializer_list<const char*> choices) {
  const auto at = std::find(choices.begin(), choices.end(), now);
  return at == choices.end() || at + 1 == choices.end() ? *choices.begin() : *(at + 1);
}

void apply_modes(ViewerState& state, const ForestScene& scene, const glm::ivec2& size_px,
                 const Presses& pressed) {
  ViewCamera& camera = state.camera;
  const std::pair<int, ViewCamera::Mode> modes[] = {{GLFW_KEY_1, ViewCamera::Mode::orbit},
                                                    {GLFW_KEY_2, ViewCamera::Mode::fly},
                                                    {GLFW_KEY_3, ViewCamera::Mode::walk}};
  for (const auto& [key, mode] : modes) {
    if (pressed(key)) camera = switched(camera, mode, scene.terrain);
  }
  if (pressed(GLFW_KEY_HOME)) camera = framing(scene, size_px, view_angle(state.options));
}

void apply_switches(ViewerState& state, const Presses& pressed) {
  ViewOptions& options = state.options;
  if (pressed(GLFW_KEY_C)) {
    options.colours = next_choice(options.colours, {"tree", "levels", "cells", "pruned"});
  }
  if (pressed(GLFW_KEY_B)) options.blend = next_choice(options.blend, {"fading", "linear"});
  if (pressed(GLFW_KEY_V)) options.cameras = !options.cameras;
  if (pressed(GLFW_KEY_TAB)) state.panel = !state.panel;
  if (pressed(GLFW_KEY_H) || pressed(GLFW_KEY_F1)) state.keys = !state.keys;
  if (pressed(GLFW_KEY_P) || pressed(GLFW_KEY_F12)) state.picture_wanted = true;
  if (pressed(GLFW_KEY_ESCAPE)) state.close_wanted = true;
}

void apply_mouse(ViewerState& state, const ForestScene& scene, const glm::ivec2& size_px) {
  state.camera = zoomed_by_wheel(state.camera, scene.terrain);
  state.camera =
      moved_by_drag(state.camera, scene.terrain, double(size_px.y), view_angle(state.options));
}

}  // namespace

const std::vector<KeyHelp>& viewer_keys() {
  static const std::vector<KeyHelp> keys = {
      {"drag", "turn round the tree; look around when flying or walking"},
      {"right drag, Shift + drag", "move sideways"},
      {"wheel", "nearer or farther; speed when flying or walking"},
      {"W A S D, E Q", "move, up and down; with Shift fast"},
      {"1, 2, 3", "orbit, fly, walk on the ground"},
      {"Home", "show all again"},
      {"C", "colours: the tree's own, levels, cells, pruned"},
      {"B", "blend rule of the baked views"},
      {"V", "cameras that the textures were baked towards"},
      {"P, F12", "save the picture as PNG"},
      {"Tab", "hide or show the panels"},
      {"H, F1", "this help"},
      {"Esc", "close"},
  };
  return keys;
}

bool apply_input(ViewerState& state, const ForestScene& scene, const glm::ivec2& size_px,
                 std::span<const int> pressed, double seconds) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.WantCaptureMouse) apply_mouse(state, scene, size_px);
  if (io.WantTextInput || io.KeyCtrl || io.KeyAlt || io.KeySuper) return false;
  apply_modes(state, scene, size_px, {pressed});
  apply_switches(state, {pressed});
  const Strides strides = strides_held();
  if (!is_moving(strides)) return false;
  constexpr double kLongestStep = 0.5;  // seconds: a slow frame must not throw the eye far
  state.camera = moved(state.camera, strides, std::min(seconds, kLongestStep), scene.terrain);
  return true;
}

}  // namespace bosk
