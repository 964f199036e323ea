#include <imgui.h>

#include <cmath>
#include <span>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/table_head.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/camera_measures.h"
#include "ui/workstation/photos/camera_wheel.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

const TableColumn kColumns[] = {
    {"Photo", "its name"},
    {"Focal px", "focal length in pixels of the photo as taken"},
    {"Lens", "the model of its distortion, and the first coefficient"},
    {"Distance",
     "from the camera to what all cameras look at; metres where the world is in metres"},
    {"Height", "of the camera over the world's ground, z = 0"},
    {"Pitch", "degrees that the camera looks up; negative: down"},
    {"Difference",
     "mean difference of opacity between matte and volume, over the pixels that "
     "either shows; in brackets PSNR of colour and opacity"},
};

// The last column is there where there is something to compare.
std::span<const TableColumn> columns(bool compared) {
  return std::span(kColumns).first(std::size(kColumns) - (compared ? 0 : 1));
}

void draw_difference(const PhotoDifferences& differences, const std::string& name) {
  const auto found = differences.by_name.find(name);
  if (differences.by_name.empty()) return ImGui::TextDisabled("waits");
  if (found == differences.by_name.end()) return ImGui::TextDisabled("no matte");
  const PhotoResidual& residual = found->second;
  if (differences.has_colour && std::isfinite(residual.psnr_db)) {
    ImGui::Text("%.3f (%.1f dB)", residual.alpha_error, residual.psnr_db);
  } else {
    ImGui::Text("%.3f", residual.alpha_error);
  }
}

void draw_row(CalibrateStepState& state, const CameraMeasures& camera, bool compared) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool selected = state.selected == camera.name;
  if (ImGui::Selectable(camera.name.c_str(), selected, ImGuiSelectableFlags_SpanAllColumns)) {
    state.selected = camera.name;
  }
  mark("calibrate/row/" + camera.name);
  ImGui::TableNextColumn();
  ImGui::Text("%.0f", camera.focal_px);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(camera.lens.c_str());
  ImGui::TableNextColumn();
  ImGui::Text("%.2f", camera.distance);
  ImGui::TableNextColumn();
  ImGui::Text("%.2f", camera.height);
  ImGui::TableNextColumn();
  ImGui::Text("%.1f", camera.pitch_deg);
  if (!compared) return;
  ImGui::TableNextColumn();
  draw_difference(state.differences, camera.name);
}

}  // namespace

void draw_camera_table(Workspace& workspace, const std::vector<Camera>& cameras) {
  const std::string obstacle = obstacle_to_differences(workspace);
  if (!obstacle.empty()) paragraph(Tone::muted, "Difference: " + obstacle + ".");
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings;
  const bool compared = obstacle.empty();
  const auto shown = columns(compared);
  if (!ImGui::BeginTable("cameras", int(shown.size()), flags)) return;
  draw_table_head(shown);
  const glm::dvec3 middle = middle_of(cameras);
  for (const Camera& camera : cameras) {
    draw_row(workspace.calibrate, measures_of(camera, middle), compared);
  }
  ImGui::EndTable();
}

}  // namespace bosk
