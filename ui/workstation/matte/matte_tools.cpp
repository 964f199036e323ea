#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/matte/matte_paint.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kFineStep = 1.1, kCoarseStep = 1.5;  // of the brush's radius

ImU32 colour_of(MatteTool tool) {
  if (tool == MatteTool::eraser) return IM_COL32(180, 180, 180, 255);
  const glm::vec3& c = tool == MatteTool::tree ? kForegroundStrokeSrgb : kBackgroundStrokeSrgb;
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1.0f});
}

void draw_tool(Workspace& workspace, MatteTool tool, const std::string& landmark,
               const char* help) {
  MatteBrush& brush = workspace.matte.brush;
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 3.0f}, {at.x + side, at.y + 3.0f + side},
                                            colour_of(tool));
  ImGui::Dummy({side, side});
  ImGui::SameLine();
  if (ImGui::RadioButton(name_of(tool), brush.tool == tool)) take_tool(brush, tool);
  mark(landmark);
  tooltip(help);
}

void draw_brush_choice(Workspace& workspace) {
  MatteBrush& brush = workspace.matte.brush;
  ImGui::BeginDisabled(!strokes_obstacle(workspace).empty());
  draw_tool(workspace, MatteTool::tree, "matte/tree",
            "paint over the tree: leaves in light and in shade, and the trunk (X swaps, hold Alt "
            "for the other)");
  draw_tool(workspace, MatteTool::background, "matte/background",
            "paint over what is not the tree: sky, ground, other trees (X swaps, hold Alt for the "
            "other)");
  draw_tool(workspace, MatteTool::eraser, "matte/eraser", "take strokes away (E)");
  float radius = float(brush.radius_of(brush.tool));
  if (ImGui::SliderFloat("radius", &radius, float(kLeastBrushPx), float(kLargestBrushPx), "%.1f px",
                         ImGuiSliderFlags_Logarithmic)) {
    set_radius(brush, brush.tool, double(radius));
  }
  mark("matte/radius");
  tooltip(
      "of the brush, in pixels of the working photo; each tool has its own ([ and ], with "
      "Shift in larger steps; or drag with the right button)");
  ImGui::EndDisabled();
}

void draw_view_choice(Workspace& workspace) {
  MatteView& view = workspace.matte.view;
  if (ImGui::BeginCombo("view", name_of(view))) {
    for (int i = 0; i < kMatteViews; ++i) {
      if (ImGui::Selectable(name_of(MatteView(i)), view == MatteView(i))) view = MatteView(i);
      mark("matte/view/" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
  mark("matte/view");
  tooltip("what is shown of the photo (F for the next)");
}

void draw_run(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  std::string obstacle = obstacle_to_stages(workspace);
  const StageState state = state_of(workspace, "matte");
  if (is_running(workspace, "matte")) obstacle = "at work; stop it below";
  if (obstacle.empty() && state == StageState::current) obstacle = "nothing changed since";
  if (button("matte/run", "Matte all photos",
             "at full size, with what the strokes on all photos teach; without strokes the tree is "
             "guessed, to be corrected",
             obstacle)) {
    run_to(workspace, "matte");
  }
  ImGui::Checkbox("keep up", &step.keep_up);
  mark("matte/keep_up");
  tooltip("matte all photos again whenever a stroke is finished");
  const std::string no_others = workspace.project().photos.size() < 2 ? "there is no other" : "";
  const bool finished = state == StageState::current;
  if (button("matte/apply", "Apply to the other photos",
             "mattes all photos by the strokes there are and shows them side by side, those most "
             "in doubt first",
             no_others.empty() && !finished ? obstacle : no_others)) {
    run_to(workspace, "matte");
    step.sheet = step.doubt_first = true;
    if (step.view == MatteView::photo) step.view = MatteView::on_black;
  }
  if (button("matte/clear", "Remove all strokes of this photo", "undo brings them back",
             strokes_on(workspace, step.photo).empty() ? "there are none" : "")) {
    edit(workspace, clear_edit(workspace.project(), step.photo));
  }
}

void hear_size_key(MatteBrush& brush, bool larger, bool coarse) {
  const double step = coarse ? kCoarseStep : kFineStep;
  set_radius(brush, brush.tool, brush.radius_of(brush.tool) * (larger ? step : 1.0 / step));
}

void show_neighbour(Workspace& workspace, int by) {
  MatteStepState& step = workspace.matte;
  const auto names = photos_in_order(step.review, step.doubt_first);
  const auto here = std::find(names.begin(), names.end(), step.photo);
  if (here == names.end()) return;
  const auto place =
      std::clamp<std::ptrdiff_t>(here - names.begin() + by, 0, std::ptrdiff_t(names.size()) - 1);
  step.photo = names[std::size_t(place)];
}

}  // namespace

void hear_matte_keys(Workspace& workspace) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.WantTextInput) return;
  MatteStepState& step = workspace.matte;
  for (const int key : workspace.input.keys) {
    switch (key) {
      case kKeyLeftBracket:
      case kKeyRightBracket:
        hear_size_key(step.brush, key == kKeyRightBracket, io.KeyShift);
        break;
      case 'X':
        swap_sides(step.brush);
        break;
      case 'E':
        toggle_eraser(step.brush);
        break;
      case 'F':
        step.view = view_after(step.view);
        break;
      case 'S':
        keep_stroke_in_hand(workspace);  // the sheet would not hear its end
        step.sheet = !step.sheet;
        break;
      case kKeyPageDown:
      case kKeyPageUp:
        show_neighbour(workspace, key == kKeyPageDown ? 1 : -1);
        break;
      default:
        break;
    }
  }
}

void draw_matte_tools(Workspace& workspace) {
  const std::string obstacle = strokes_obstacle(workspace);
  if (!obstacle.empty()) paragraph(Tone::note, obstacle);
  ImGui::PushItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
  draw_brush_choice(workspace);
  draw_view_choice(workspace);
  ImGui::PopItemWidth();
  ImGui::Separator();
  draw_run(workspace);
  ImGui::Separator();
  draw_matte_photos(workspace);
  if (ImGui::CollapsingHeader("Options")) draw_stage_options(workspace, "matte");
  mark("matte/options");
  if (workspace.project().mattes.empty()) {
    paragraph(Tone::muted, "Finished mattes, called like the photos? Drop their folder here.");
  }
}

}  // namespace bosk
