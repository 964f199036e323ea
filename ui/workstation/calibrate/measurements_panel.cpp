#include <imgui.h>

#include <cfloat>
#include <utility>

#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/calibration_words.h"
#include "ui/workstation/calibrate/photo_marks.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kMetresPerMm = 1e-3;
constexpr ImGuiTableFlags kTable =
    ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_NoSavedSettings;

// A number that is taken when its field is let go. `unit_m` is what the field shows one of.
bool draw_length(CalibrateStepState& state, const std::string& name, double& metres, double unit_m,
                 const char* format) {
  NumberInHand& in_hand = state.number_in_hand;
  double shown = in_hand.name == name ? in_hand.value : metres / unit_m;
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (ImGui::InputDouble(("##" + name).c_str(), &shown, 0.0, 0.0, format)) in_hand = {name, shown};
  const bool let_go = ImGui::IsItemDeactivated() && in_hand.name == name;
  mark(name);
  if (!let_go) return false;
  metres = in_hand.value * unit_m;
  in_hand = {};
  return true;
}

// `hint` stands there while nothing is chosen.
bool draw_point_choice(const std::string& name, const std::vector<PointRow>& points,
                       const char* hint, std::string& chosen) {
  bool changed = false;
  ImGui::SetNextItemWidth(-FLT_MIN);
  // A name has room in a table without the arrow, and says by itself what the field is for
  const ImGuiComboFlags arrow = chosen.empty() ? 0 : ImGuiComboFlags_NoArrowButton;
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), chosen.empty() ? hint : chosen.c_str(),
                                      arrow | ImGuiComboFlags_HeightLarge);
  mark(name);
  if (!open) tooltip(chosen);
  if (!open) return false;
  for (const PointRow& point : points) {
    if (ImGui::Selectable(point.name.c_str(), point.name == chosen)) {
      changed = point.name != chosen;
      chosen = point.name;
    }
    mark(name + "/" + point.name);
  }
  ImGui::EndCombo();
  return changed;
}

bool draw_removal(const std::string& name) {
  ImGui::TableNextColumn();
  return button(name, "x", "removes it; undo brings it back");
}

// The column without a name is the one of the button that removes a row.
void draw_head(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    ImGui::TableSetupColumn(name, *name == '\0' ? ImGuiTableColumnFlags_WidthFixed
                                                : ImGuiTableColumnFlags_WidthStretch);
  }
  ImGui::TableHeadersRow();
}

// What a row of a table asks for.
enum class RowChange { none, edited, removed };

RowChange draw_tape(CalibrateStepState& state, const std::vector<PointRow>& points,
                    const std::string& name, Tape& tape) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  bool changed = draw_point_choice(name + "/from", points, "from", tape.from);
  ImGui::TableNextColumn();
  changed |= draw_point_choice(name + "/to", points, "to", tape.to);
  ImGui::TableNextColumn();
  changed |= draw_length(state, name + "/metres", tape.length_m, 1.0, "%.3f");
  ImGui::TableNextColumn();
  changed |= draw_length(state, name + "/sigma", tape.sigma_m, kMetresPerMm, "%.1f");
  if (draw_removal(name + "/remove")) return RowChange::removed;
  return changed ? RowChange::edited : RowChange::none;
}

RowChange draw_height(CalibrateStepState& state, const std::vector<PointRow>& points,
                      const std::string& name, Height& height) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  bool changed = draw_point_choice(name + "/point", points, "height of", height.point);
  ImGui::TableNextColumn();
  changed |= draw_length(state, name + "/metres", height.height_m, 1.0, "%.3f");
  ImGui::TableNextColumn();
  changed |= draw_length(state, name + "/sigma", height.sigma_m, kMetresPerMm, "%.1f");
  if (draw_removal(name + "/remove")) return RowChange::removed;
  return changed ? RowChange::edited : RowChange::none;
}

// Draws the rows of a list; what the hand did to one of them is one edit of the whole.
template <class Item, class DrawRow>
void draw_rows(Workspace& workspace, std::vector<Item> Measurements::*list, const std::string& name,
               const DrawRow& draw_row) {
  Measurements after = workspace.project().calibration.measurements;
  RowChange change = RowChange::none;
  for (std::size_t i = 0; i < (after.*list).size(); ++i) {
    const RowChange row = draw_row(name + "/" + std::to_string(i), (after.*list)[i]);
    if (row == RowChange::none) continue;
    change = row;
    if (row == RowChange::removed) (after.*list).erase((after.*list).begin() + std::ptrdiff_t(i));
    break;  // the rest is drawn again in the next frame
  }
  if (change != RowChange::none) {
    edit_or_tell(workspace, measurements_edit(workspace.project(), std::move(after)));
  }
}

void draw_tapes(Workspace& workspace, const std::vector<PointRow>& points) {
  CalibrateStepState& state = workspace.calibrate;
  if (workspace.project().calibration.measurements.tapes.empty()) return;
  if (!ImGui::BeginTable("tapes", 5, kTable)) return;
  draw_head({"From", "To", "m", "+- mm", ""});
  draw_rows(
      workspace, &Measurements::tapes, "calibrate/tape",
      [&](const std::string& name, Tape& tape) { return draw_tape(state, points, name, tape); });
  ImGui::EndTable();
}

void draw_heights(Workspace& workspace, const std::vector<PointRow>& points) {
  CalibrateStepState& state = workspace.calibrate;
  if (workspace.project().calibration.measurements.heights.empty()) return;
  if (!ImGui::BeginTable("heights", 4, kTable)) return;
  draw_head({"Height of", "m", "+- mm", ""});
  draw_rows(workspace, &Measurements::heights, "calibrate/height",
            [&](const std::string& name, Height& height) {
              return draw_height(state, points, name, height);
            });
  ImGui::EndTable();
}

bool draw_place(CalibrateStepState& state, const std::string& name, SurveyedPoint& point) {
  bool changed = false;
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::TableNextColumn();
    changed |= draw_length(state, name + "/" + "xyz"[axis], point.in_world[axis], 1.0, "%.3f");
  }
  return changed;
}

RowChange draw_surveyed(CalibrateStepState& state, const std::vector<PointRow>& points,
                        const std::string& name, SurveyedPoint& point) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  bool changed = draw_point_choice(name + "/point", points, "point", point.point);
  changed |= draw_place(state, name, point);
  ImGui::TableNextColumn();
  changed |= draw_length(state, name + "/sigma", point.sigma_m, kMetresPerMm, "%.1f");
  if (draw_removal(name + "/remove")) return RowChange::removed;
  return changed ? RowChange::edited : RowChange::none;
}

void draw_surveyed_points(Workspace& workspace, const std::vector<PointRow>& points) {
  CalibrateStepState& state = workspace.calibrate;
  if (workspace.project().calibration.measurements.points.empty()) return;
  if (!ImGui::BeginTable("surveyed", 6, kTable)) return;
  draw_head({"Place of", "x m", "y m", "z m", "+- mm", ""});
  draw_rows(workspace, &Measurements::points, "calibrate/surveyed",
            [&](const std::string& name, SurveyedPoint& point) {
              return draw_surveyed(state, points, name, point);
            });
  ImGui::EndTable();
}

void draw_results(const Workspace& workspace) {
  const auto calibration = workspace.calibrate.solved.calibration;
  if (!calibration) return;
  const Measurements& measured = workspace.project().calibration.measurements;
  for (const Tape& tape : measured.tapes) {
    const auto words = tape_words(*calibration, tape);
    if (words) paragraph(Tone::muted, tape.from + " to " + tape.to + ": " + *words + ".");
  }
  for (const Height& height : measured.heights) {
    const auto words = height_words(*calibration, height);
    if (words) paragraph(Tone::muted, "height of " + height.point + ": " + *words + ".");
  }
}

template <class Item>
void add(Workspace& workspace, std::vector<Item> Measurements::*list, Item& item) {
  Measurements after = workspace.project().calibration.measurements;
  (after.*list).push_back(std::exchange(item, {}));
  edit_or_tell(workspace, measurements_edit(workspace.project(), std::move(after)));
}

// The measurement that is typed next; points and a length are chosen, then it is added.
void draw_new_tape(Workspace& workspace, const std::vector<PointRow>& points) {
  CalibrateStepState& state = workspace.calibrate;
  Tape& tape = state.new_tape;
  if (ImGui::BeginTable("new tape", 3)) {
    ImGui::TableNextColumn();
    draw_point_choice("calibrate/new_tape/from", points, "from", tape.from);
    ImGui::TableNextColumn();
    draw_point_choice("calibrate/new_tape/to", points, "to", tape.to);
    ImGui::TableNextColumn();
    draw_length(state, "calibrate/new_tape/metres", tape.length_m, 1.0, "%.3f m");
    ImGui::EndTable();
  }
  const std::string obstacle = obstacle_to_tape(tape);
  if (button("calibrate/new_tape/add", "Add tape",
             "a length measured between two points, for scale", obstacle)) {
    add(workspace, &Measurements::tapes, tape);
  }
}

void draw_new_height(Workspace& workspace, const std::vector<PointRow>& points) {
  CalibrateStepState& state = workspace.calibrate;
  Height& height = state.new_height;
  if (ImGui::BeginTable("new height", 2)) {
    ImGui::TableNextColumn();
    draw_point_choice("calibrate/new_height/point", points, "height of", height.point);
    ImGui::TableNextColumn();
    draw_length(state, "calibrate/new_height/metres", height.height_m, 1.0, "%.3f m");
    ImGui::EndTable();
  }
  if (button("calibrate/new_height/add", "Add height",
             "of a point above the ground at the foot of the trunk: a stick's length up to its "
             "ball's centre, for scale and up",
             height.point.empty() ? "choose a point" : "")) {
    add(workspace, &Measurements::heights, height);
  }
}

void draw_new_surveyed(Workspace& workspace, const std::vector<PointRow>& points) {
  CalibrateStepState& state = workspace.calibrate;
  SurveyedPoint& point = state.new_surveyed;
  if (ImGui::BeginTable("new surveyed", 4)) {
    ImGui::TableNextColumn();
    draw_point_choice("calibrate/new_surveyed/point", points, "point", point.point);
    draw_place(state, "calibrate/new_surveyed", point);
    ImGui::EndTable();
  }
  if (button("calibrate/new_surveyed/add", "Add surveyed point",
             "x, y and z of a point, z up, from wherever the survey counts; three of them that are "
             "not on a line fix scale, up and place of the world",
             point.point.empty() ? "choose a point" : "")) {
    add(workspace, &Measurements::points, point);
  }
}

}  // namespace

void draw_measurements(Workspace& workspace) {
  const std::vector<PointRow> points = listed_points(workspace);
  draw_tapes(workspace, points);
  draw_new_tape(workspace, points);
  draw_heights(workspace, points);
  draw_new_height(workspace, points);
  draw_surveyed_points(workspace, points);
  draw_new_surveyed(workspace, points);
  draw_results(workspace);
}

}  // namespace bosk
