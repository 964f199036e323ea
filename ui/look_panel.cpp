#include <imgui.h>

#include "ui/widgets/option_widget.h"
#include "ui/viewer_state.h"

namespace bosk {
namespace {

const char* name_of(ViewCamera::Mode mode) {
  switch (mode) {
    case ViewCamera::Mode::orbit:
      return "orbit (1)";
    case ViewCamera::Mode::fly:
      return "fly (2)";
    case ViewCamera::Mode::walk:
      return "walk (3)";
  }
  return "";
}

}  // namespace

void draw_look_panel(ViewerState& state) {
  const ImVec2 corner(ImGui::GetIO().DisplaySize.x - 8, 8);
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 0});
  ImGui::SetNextWindowBgAlpha(0.7f);
  if (ImGui::Begin("Look", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    ImGui::PushItemWidth(9.0f * ImGui::GetFontSize());
    for (const Option& option : describe(state.options)) draw_option(option);
    ImGui::PopItemWidth();
    ImGui::Separator();
    const glm::dvec3& eye = state.camera.eye;
    ImGui::Text("%s, %.3g m/s", name_of(state.camera.mode), state.camera.speed);
    ImGui::Text("eye %.2f %.2f %.2f m", eye.x, eye.y, eye.z);
    ImGui::TextDisabled("H: keys, Tab: hide");
  }
  ImGui::End();
}

}  // namespace bosk
