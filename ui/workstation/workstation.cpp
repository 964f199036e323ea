#include "ui/workstation/workstation.h"

#include <imgui.h>

#include "core/base/error.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/guide.h"
#include "ui/workstation/matte/matte_paint.h"
#include "ui/workstation/named_paths.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kStepsEms = 13.0f, kJobsEms = 5.6f;  // widths and heights of the bars

void draw_header(const Workspace& workspace) {
  const StepGuide guide = guide_of(workspace, workspace.step);
  const StepText& text = text_of(workspace.step);
  title(text.name);
  ImGui::SameLine();
  badge(guide.tone, guide.state);
  ImGui::SameLine();
  ImGui::TextDisabled("%s", text.purpose);
  if (!guide.needs.empty()) paragraph(Tone::note, "Needs " + guide.needs + ".");
  std::string line = guide.has;
  if (!guide.next.empty()) line += (line.empty() ? "Next: " : ". Next: ") + guide.next;
  if (!line.empty()) paragraph(line + ".");
  ImGui::Separator();
}

void draw_step(Workspace& workspace) {
  switch (workspace.step) {
    case WorkStep::photos:
      return draw_photos_step(workspace);
    case WorkStep::calibrate:
      return draw_calibrate_step(workspace);
    case WorkStep::matte:
      return draw_matte_step(workspace);
    case WorkStep::volume:
      return draw_volume_step(workspace);
    case WorkStep::textures:
      return draw_textures_step(workspace);
    case WorkStep::codebook:
      return draw_codebook_step(workspace);
    case WorkStep::preview:
      return draw_preview_step(workspace);
    case WorkStep::export_tree:
      return draw_export_step(workspace);
  }
}

void draw_project(Workspace& workspace) {
  const float em = ImGui::GetFontSize();
  const float jobs_height = kJobsEms * em;
  ImGui::BeginChild("steps", {kStepsEms * em, -jobs_height}, true);
  draw_steps_bar(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("step", {0, -jobs_height}, true, ImGuiWindowFlags_NoScrollWithMouse);
  if (workspace.session) {
    draw_header(workspace);
    draw_step(workspace);
  }
  ImGui::EndChild();
  ImGui::BeginChild("jobs", {0, 0}, true);
  draw_jobs_bar(workspace);
  ImGui::EndChild();
}

}  // namespace

void draw_workstation(Workspace& workspace) {
  begin_landmarks(workspace.landmarks);
  workspace.next_frame = NextFrame::when_heard;
  refresh(workspace);
  hear_shortcuts(workspace);
  const bool away = workspace.input.focus_lost || workspace.step != WorkStep::matte;
  if (away) keep_stroke_in_hand(workspace);
  hear_drops(workspace);
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("Bosk", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings);
  if (workspace.session) {
    draw_project(workspace);
  } else {
    draw_start_page(workspace);
  }
  ImGui::End();
  draw_shortcuts(workspace);
  workspace.pictures.end_frame();
  workspace.input = {};
}

}  // namespace bosk
