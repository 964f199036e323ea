#include <imgui.h>

#include "ui/viewer_state.h"
#include "ui/widgets/figures_table.h"

namespace bosk {

void draw_figures_panel(const ViewerState& state) {
  ImGui::SetNextWindowPos({8, 8}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowBgAlpha(0.7f);
  if (ImGui::Begin("Figures", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    draw_figures_table(state.figures);
  }
  ImGui::End();
}

}  // namespace bosk
