#include <imgui.h>

#include "ui/viewer_input.h"

namespace bosk {

void draw_keys_panel(ViewerState& state) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Keys", &state.keys, ImGuiWindowFlags_AlwaysAutoResize) &&
      ImGui::BeginTable("keys", 2)) {
    for (const KeyHelp& help : viewer_keys()) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(help.keys.c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(help.what.c_str());
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace bosk
