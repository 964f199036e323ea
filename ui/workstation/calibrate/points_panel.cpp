#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/table_head.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/photo_marks.h"
#include "ui/workstation/calibrate/point_colours.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kTableEms = 14.0f;  // its height

void draw_swatch(const std::string& name) {
  const glm::vec3 c = colour_of_point(name);
  const float side = 0.7f * ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled(
      {at.x + 0.5f * side, at.y + 0.5f * ImGui::GetTextLineHeight()}, 0.5f * side,
      ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1.0f}));
  ImGui::Dummy({side, side});
  ImGui::SameLine();
}

void draw_number(const char* format, const std::optional<double>& value) {
  ImGui::TableNextColumn();
  if (value) {
    ImGui::Text(format, *value);
  } else {
    ImGui::TextDisabled("none");
  }
}

// The list scrolls to a point that was chosen on the photo; later it stays where the hand puts it.
void show_once_chosen(CalibrateStepState& state, const std::string& point) {
  if (state.canvas.point != point || state.shown_in_list == point) return;
  if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
  state.shown_in_list = point;
}

void draw_row(Workspace& workspace, const PointRow& row) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_swatch(row.name);
  if (ImGui::Selectable(row.name.c_str(), canvas.point == row.name,
                        ImGuiSelectableFlags_SpanAllColumns)) {
    canvas.point = row.name;
    workspace.calibrate.rename_to = row.name;
  }
  mark("calibrate/point/" + row.name);
  show_once_chosen(workspace.calibrate, row.name);
  ImGui::TableNextColumn();
  ImGui::Text("%d", row.photos);
  draw_number("%.2f", row.rms_px);
  const std::optional<double> sigma_mm =
      row.sigma_m ? std::optional(1000.0 * *row.sigma_m) : std::nullopt;
  draw_number("%.1f", sigma_mm);
}

void draw_table(Workspace& workspace, const std::vector<PointRow>& rows) {
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit |
                                ImGuiTableFlags_NoSavedSettings;
  const float wanted = float(rows.size() + 2) * ImGui::GetTextLineHeightWithSpacing();
  const float height = std::min(kTableEms * ImGui::GetFontSize(), wanted);
  if (!ImGui::BeginTable("points", 4, flags, {0.0f, height})) return;
  const bool metres =
      workspace.calibrate.solved.calibration && workspace.calibrate.solved.calibration->scale_known;
  const TableColumn columns[] = {
      {"Point", "click one to place it on the photo"},
      {"Photos", "that it is seen in"},
      {"px", "root mean square of its errors in the newest solve; left-out sightings aside"},
      {metres ? "mm" : "per mille", metres ? "one sigma of its place, over all three axes"
                                           : "the same as a share of the cameras' distance"}};
  draw_table_head(columns);
  for (const PointRow& row : rows) draw_row(workspace, row);
  ImGui::EndTable();
}

void draw_new_point(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  ImGui::SetNextItemWidth(10.0f * ImGui::GetFontSize());
  const bool entered = ImGui::InputTextWithHint(
      "##new point", "name of a new point", &state.new_point, ImGuiInputTextFlags_EnterReturnsTrue);
  mark("calibrate/new_point");
  ImGui::SameLine();
  const bool pressed = button("calibrate/take_point", "New",
                              "then click it on two photos or more: anything that is sharp and "
                              "stays where it is will do",
                              obstacle_to_name(state.new_point));
  if (!(entered || pressed) || !obstacle_to_name(state.new_point).empty()) return;
  state.canvas.point = state.rename_to = state.new_point;
  state.new_point.clear();
}

void rename_everywhere(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  const std::string from = state.canvas.point, to = state.rename_to;
  std::vector<std::string> photos;
  for (const auto& photo : workspace.project().photos) photos.push_back(photo.stem().string());
  const Project& project = workspace.project();
  RenamePoint rename{
      renaming_edit(project, state.solved.finds.get(), photos, from, to),
      measurements_edit(project, renamed(project.calibration.measurements, from, to))};
  const bool is_measured = !(rename.measured.after == rename.measured.before);
  if (is_measured || !rename.seen.sightings.empty()) edit_or_tell(workspace, std::move(rename));
  state.canvas.point = to;
}

void rename_here(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  const PhotoRow* row = row_on_canvas(workspace);
  if (!row) return;
  const std::string here[] = {row->name};
  SetSightings change = renaming_edit(workspace.project(), state.solved.finds.get(), here,
                                      state.canvas.point, state.rename_to);
  if (change.sightings.empty()) return;
  edit_or_tell(workspace, std::move(change));
  state.canvas.point = state.rename_to;
}

void draw_renaming(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  if (state.canvas.point.empty()) return;
  ImGui::SetNextItemWidth(10.0f * ImGui::GetFontSize());
  ImGui::InputText("##rename", &state.rename_to);
  mark("calibrate/rename_to");
  const std::string obstacle = state.rename_to == state.canvas.point
                                   ? "type another name for " + state.canvas.point
                                   : obstacle_to_name(state.rename_to);
  ImGui::SameLine();
  if (button("calibrate/rename", "Rename",
             "in all photos and measurements; a photo that has both "
             "names exchanges them",
             obstacle)) {
    rename_everywhere(workspace);
  }
  ImGui::SameLine();
  if (button("calibrate/rename_here", "Here", "on this photo alone: it was taken for another point",
             obstacle)) {
    rename_here(workspace);
  }
}

const HandSighting* told_here(const Workspace& workspace) {
  const PhotoRow* row = row_on_canvas(workspace);
  const HandSightings& told = workspace.project().calibration.sightings;
  const auto photo = row ? told.find(row->name) : told.end();
  if (photo == told.end()) return nullptr;
  const auto said = photo->second.find(workspace.calibrate.canvas.point);
  return said == photo->second.end() ? nullptr : &said->second;
}

void draw_here(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  if (state.canvas.point.empty()) return;
  if (button("calibrate/remove", "Not on this photo",
             "Delete: it isn't seen here, and stays so when markers are found again")) {
    remove_chosen_mark(workspace);
  }
  ImGui::SameLine();
  const PhotoRow* row = row_on_canvas(workspace);
  if (button("calibrate/as_found", "As found", "takes back what was said of it on this photo",
             told_here(workspace) ? "" : "nothing was said of it on this photo")) {
    edit_or_tell(workspace,
                 sighting_edit(workspace.project(), row->name, state.canvas.point, std::nullopt));
  }
}

}  // namespace

const std::vector<PointRow>& listed_points(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  const std::uint64_t session = workspace.session->revision() + 1;
  if (state.points_session == session && state.points_solved == state.solved.revision) {
    return state.points;
  }
  state.points_session = session;
  state.points_solved = state.solved.revision;
  state.points = points_of(state.solved.finds.get(), workspace.project().calibration,
                           state.solved.calibration.get());
  return state.points;
}

void draw_points(Workspace& workspace) {
  const std::vector<PointRow> rows = listed_points(workspace);
  if (rows.empty()) {
    paragraph(Tone::muted,
              "No points yet. Coloured balls are found by themselves; anything else can be named "
              "here and clicked on the photos.");
  } else {
    draw_table(workspace, rows);
  }
  draw_new_point(workspace);
  draw_renaming(workspace);
  draw_here(workspace);
}

}  // namespace bosk
