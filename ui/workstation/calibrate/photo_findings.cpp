#include <imgui.h>

#include <iterator>

#include "core/project/calibration_figures.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/table_head.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/calibration_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

const TableColumn kColumns[] = {
    {"Photo", "click one to see it"},
    {"Fate", "placed, uncertain (placed, but look at it), or not placed (it has no camera)"},
    {"Seen", "sightings of points that other photos see too"},
    {"Left out", "sightings that disagree with all the others"},
    {"px", "root mean square of the errors, those left out aside"},
    {"Crown px", "uncertainty of the pose as seen at the crown: one sigma, in pixels"},
    {"Why", "what is wrong with it, and what to do"},
};

void draw_row(Workspace& workspace, const PhotoFinding& photo) {
  CalibrateStepState& state = workspace.calibrate;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const PhotoRow* shown = row_on_canvas(workspace);
  const bool chosen = shown && shown->name == photo.photo;
  if (ImGui::Selectable(photo.photo.c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns)) {
    show_on_canvas(workspace, photo.photo);
    state.selected = photo.photo;
    state.shown = CalibrateView::photo;
  }
  mark("calibrate/finding/" + photo.photo);
  ImGui::TableNextColumn();
  badge(tone_of(photo.fate), fate_words(photo.fate));
  ImGui::TableNextColumn();
  ImGui::Text("%d", photo.sightings);
  ImGui::TableNextColumn();
  ImGui::Text("%d", photo.outliers);
  ImGui::TableNextColumn();
  ImGui::Text("%.2f", photo.rms_px);
  ImGui::TableNextColumn();
  ImGui::Text("%.2f", photo.crown_sigma_px);
  ImGui::TableNextColumn();
  ImGui::TextColored(colour_of(tone_of(photo.fate)), "%s", photo.reason.c_str());
  tooltip(photo.reason);
}

}  // namespace

void draw_photo_findings(Workspace& workspace) {
  const auto calibration = workspace.calibrate.solved.calibration;
  if (!calibration) return;
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings;
  if (!ImGui::BeginTable("findings", int(std::size(kColumns)), flags)) return;
  draw_table_head(kColumns);
  for (const PhotoFinding& photo : calibration->photos) draw_row(workspace, photo);
  ImGui::EndTable();
}

}  // namespace bosk
