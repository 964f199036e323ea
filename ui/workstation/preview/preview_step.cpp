#include "ui/workstation/preview/preview_step.h"

#include <imgui.h>

#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

void draw_tab(PreviewStepState& state, PreviewTab tab, const char* name, const char* label,
              const char* help) {
  const bool chosen = state.tab == tab;
  if (chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  }
  if (button(name, label, help)) state.tab = tab;
  if (chosen) ImGui::PopStyleColor();
}

void draw_tabs(PreviewStepState& state) {
  draw_tab(state, PreviewTab::look, "preview/look", "Look", "the tree from anywhere, or a forest");
  ImGui::SameLine();
  draw_tab(state, PreviewTab::compare, "preview/compare", "Compare",
           "a photo against the tree from the same place");
  ImGui::SameLine();
  draw_tab(state, PreviewTab::scores, "preview/scores", "Scores",
           "how good it is on photos that were held out");
}

}  // namespace

bool draw_package_state(Workspace& workspace) {
  load_if_stored(workspace, "pack");
  const StageState state = state_of(workspace, "pack");
  const bool shown = workspace.results.package != nullptr && is_shown(workspace, "pack");
  if (state == StageState::current) return shown;
  if (state == StageState::outdated) {
    badge(Tone::note, "An older package is shown; the project has changed since.");
    ImGui::SameLine();
  }
  const std::string running = is_running(workspace, "pack") ? "it is being made" : "";
  const std::string obstacle = obstacle_to_stages(workspace);
  if (state != StageState::stored &&
      button("preview/make", "Make the package", "runs all stages that are not finished",
             obstacle.empty() ? running : obstacle)) {
    run_to(workspace, "pack");
  }
  return shown;
}

void draw_preview_step(Workspace& workspace) {
  PreviewStepState& state = workspace.preview;
  const bool shown = draw_package_state(workspace);
  draw_tabs(state);
  if (state.tab == PreviewTab::scores) return draw_held_out(workspace);
  if (!shown) return paragraph("There is no package to show yet.");
  if (state.tab == PreviewTab::look) return draw_live_tree(workspace);
  draw_compare(workspace);
}

}  // namespace bosk
