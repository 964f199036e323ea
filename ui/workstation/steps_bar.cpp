#include <imgui.h>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/guide.h"
#include "ui/workstation/workspace.h"
#include "ui/workstation/workstation.h"

namespace bosk {
namespace {

void draw_step_entry(Workspace& workspace, WorkStep step) {
  const StepText& text = text_of(step);
  const StepGuide guide = guide_of(workspace, step);
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const ImVec2 at = ImGui::GetCursorPos();
  const std::string label = std::string("##") + text.id;
  const bool chosen = workspace.step == step;
  if (ImGui::Selectable(label.c_str(), chosen, 0, {0, 2.0f * line})) workspace.step = step;
  mark(std::string("step/") + text.id);
  tooltip(guide.needs.empty() ? text.purpose : "Needs " + guide.needs + ".");
  const ImVec2 next = ImGui::GetCursorPos();
  ImGui::SetCursorPos(at);
  ImGui::Text("%d  %s", int(step) + 1, text.name);
  badge(guide.tone, guide.state);
  ImGui::SetCursorPos(next);
}

void draw_history(Workspace& workspace) {
  const Session& session = *workspace.session;
  const std::string undo_what = session.undo_title(), redo_what = session.redo_title();
  if (button("undo", "Undo", "Ctrl+Z: " + undo_what,
             session.can_undo() ? "" : "nothing to undo yet")) {
    undo(workspace);
  }
  ImGui::SameLine();
  if (button("redo", "Redo", "Ctrl+Shift+Z: " + redo_what,
             session.can_redo() ? "" : "nothing to redo")) {
    redo(workspace);
  }
  paragraph(Tone::muted, undo_what.empty() ? "All changes are saved as you make them."
                                           : "Last: " + undo_what + ". Saved.");
}

void draw_size_choice(Workspace& workspace) {
  const float now = scale_of(workspace);
  if (button("scale/less", "-", "Ctrl+Minus: everything smaller",
             now > kLeastScale ? "" : "this is the smallest")) {
    ask_for_scale(workspace, now - kScaleStep);
  }
  ImGui::SameLine();
  ImGui::Text("%.0f %%", double(100.0f * now));
  ImGui::SameLine();
  if (button("scale/more", "+", "Ctrl+Plus: everything larger",
             now < kLargestScale ? "" : "this is the largest")) {
    ask_for_scale(workspace, now + kScaleStep);
  }
  ImGui::SameLine();
  ImGui::TextDisabled("size");
}

}  // namespace

void draw_steps_bar(Workspace& workspace) {
  title(workspace.project().name());
  tooltip(workspace.project().absolute({}).string());
  ImGui::Separator();
  for (const WorkStep step : kSteps) draw_step_entry(workspace, step);
  ImGui::Separator();
  if (workspace.session) draw_history(workspace);
  ImGui::Separator();
  if (button("shortcuts", "Keys (F1)", "the list of keys")) workspace.shortcuts_shown = true;
  draw_size_choice(workspace);
  if (button("close", "Close", "back to the start page; everything is kept")) {
    close_project(workspace);
  }
}

}  // namespace bosk
