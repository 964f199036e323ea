#include "ui/workstation/calibrate/calibrate_step.h"

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/camera_import.h"
#include "ui/workstation/calibrate/camera_measures.h"
#include "ui/workstation/options_panel.h"
#include "ui/workstation/path_field.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kViewShare = 0.58f;  // of the width
constexpr float kMainShare = 0.68f;  // of the height, above the table
constexpr float kToolsEms = 23.0f;

void draw_import(Workspace& workspace) {
  const bool no_photos = workspace.project().photos.empty();
  const PathField field{"calibrate/path",
                        "COLMAP folder, transforms.json or .cameramodel: type, paste or drop it",
                        "calibrate/import",
                        "Import",
                        "matches the cameras there with the photos, and takes them",
                        no_photos ? "add photos first, in step Photos" : ""};
  if (const auto path = draw_path_field(field, workspace.calibrate.typed)) {
    import_cameras(workspace, *path);
  }
}

void draw_state(Workspace& workspace, const std::vector<Camera>& cameras) {
  const CalibrateStepState& state = workspace.calibrate;
  draw_notices(state.said);
  if (!state.known.trouble.empty()) paragraph(Tone::bad, state.known.trouble);
  if (cameras.empty()) return;
  if (state.said.empty()) {
    const auto without = photos_without_camera(workspace);
    const std::size_t matched = workspace.project().photos.size() - without.size();
    paragraph(without.empty() ? Tone::good : Tone::note, match_words(matched, without) + ".");
  }
  const auto orientation = [&](const std::string& name) { return orientation_of(workspace, name); };
  const UpVerdict up = up_verdict(cameras, orientation);
  paragraph(up == UpVerdict::up ? Tone::good : Tone::bad, words_of(up));
}

void draw_selected(Workspace& workspace) {
  CalibrateStepState& state = workspace.calibrate;
  const PhotoRow* row = row_of(workspace, state.selected);
  if (!row) {
    return paragraph(Tone::muted, "Click a photo in the view or in the table to see it here.");
  }
  const float height = 0.32f * ImGui::GetContentRegionAvail().y;
  const Texture picture = thumbnail_of(workspace, row->file);
  if (picture) {
    const float scale = std::min(height / float(picture.size_px.y),
                                 ImGui::GetContentRegionAvail().x / float(picture.size_px.x));
    ImGui::Image(picture.id, {scale * float(picture.size_px.x), scale * float(picture.size_px.y)});
    mark("calibrate/selected");
  }
  ImGui::TextUnformatted(row->name.c_str());
  const bool through = state.through == state.selected;
  if (button("calibrate/through", through ? "Back outside" : "Look through this camera",
             through ? "see the cameras from outside again"
                     : "stand where the photo was taken; a drag leads outside again")) {
    state.through = through ? std::string() : state.selected;
  }
  ImGui::SameLine();
  if (button("calibrate/open", "Open in Photos", "all of the photo, with its EXIF")) {
    show_photo(workspace, row->photo);
    workspace.step = WorkStep::photos;
  }
}

void draw_choice(CalibrateStepState& state, CalibrateView view, const char* label,
                 const std::string& landmark, const char* help) {
  if (ImGui::RadioButton(label, state.shown == view)) state.shown = view;
  mark(landmark);
  tooltip(help);
}

void draw_choices(CalibrateStepState& state) {
  draw_choice(state, CalibrateView::photo, "Photo", "calibrate/show/photo",
              "what is seen on a photo, to be corrected by clicks");
  ImGui::SameLine();
  draw_choice(state, CalibrateView::cameras, "Cameras", "calibrate/show/cameras",
              "cameras and points, with their error bars");
  ImGui::SameLine();
  draw_choice(state, CalibrateView::wheel, "From above", "calibrate/show/wheel",
              "where another photo would help");
  ImGui::SameLine();
  draw_choice(state, CalibrateView::lens, "Lens", "calibrate/show/lens",
              "what photos of a board say of the lens");
}

void draw_shown(Workspace& workspace, const std::vector<Camera>& cameras) {
  switch (workspace.calibrate.shown) {
    case CalibrateView::photo:
      return draw_photo_canvas(workspace);
    case CalibrateView::cameras:
      if (!cameras.empty()) return draw_frusta(workspace, cameras);
      return paragraph(Tone::muted, "No photo has a camera yet.");
    case CalibrateView::wheel:
      return draw_reshoot_wheel(workspace);
    case CalibrateView::lens:
      return draw_lens_view(workspace);
  }
}

// A part of the tools that can be folded away.
void draw_part(Workspace& workspace, const char* label, const std::string& landmark, bool open,
               void (*draw)(Workspace&)) {
  const bool shown = ImGui::CollapsingHeader(label, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  mark(landmark);
  if (shown) draw(workspace);
}

// But for those of the lens.
void draw_other_options(Workspace& workspace) {
  CalibrateOptions options;
  const auto& of_lens = lens_option_names();
  std::vector<std::string> names;
  for (const Option& option : describe(options)) {
    const bool other = std::find(of_lens.begin(), of_lens.end(), option.name) == of_lens.end();
    if (other) names.push_back(option.name);
  }
  draw_stage_options(workspace, "calibrate", names);
}

void draw_tools(Workspace& workspace) {
  draw_solving(workspace);
  draw_part(workspace, "Points", "calibrate/points", true, draw_points);
  draw_part(workspace, "Measurements", "calibrate/measurements", true, draw_measurements);
  draw_part(workspace, "Lens", "calibrate/lens", false, draw_lens_sources);
  draw_part(workspace, "Options", "calibrate/options", false, draw_other_options);
}

// Of a project without a camera file.
void draw_solved_step(Workspace& workspace, const std::vector<Camera>& cameras) {
  if (workspace.calibrate.shown == CalibrateView::photo) hear_canvas_keys(workspace);
  ImGui::BeginChild("calibrate tools", {kToolsEms * ImGui::GetFontSize(), 0.0f});
  draw_tools(workspace);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("calibrate main", {0.0f, 0.0f}, false, ImGuiWindowFlags_NoScrollWithMouse);
  draw_choices(workspace.calibrate);
  const bool findings = workspace.calibrate.solved.calibration != nullptr;
  const float height = findings ? kMainShare * ImGui::GetContentRegionAvail().y : 0.0f;
  ImGui::BeginChild("calibrate shown", {0.0f, height}, false, ImGuiWindowFlags_NoScrollWithMouse);
  draw_shown(workspace, cameras);
  ImGui::EndChild();
  draw_photo_findings(workspace);
  ImGui::EndChild();
}

void draw_way_back(Workspace& workspace) {
  if (button("calibrate/unimport", "Use calibration instead",
             "finds the cameras from the photos, without the camera file; undo brings it back")) {
    edit_or_tell(workspace, files_edit(workspace.project(), FileKind::cameras, {}));
  }
}

// Cameras may have gone by undo.
void forget_gone(CalibrateStepState& state, const std::vector<Camera>& cameras) {
  const auto is_gone = [&](const std::string& name) {
    return std::none_of(cameras.begin(), cameras.end(),
                        [&](const Camera& camera) { return camera.name == name; });
  };
  if (is_gone(state.selected)) state.selected.clear();
  if (is_gone(state.through)) state.through.clear();
}

}  // namespace

void draw_calibrate_step(Workspace& workspace) {
  follow_photos(workspace);
  follow_import(workspace);
  follow_differences(workspace);
  follow_calibration_jobs(workspace);
  const std::vector<Camera> cameras = photo_cameras(workspace);
  forget_gone(workspace.calibrate, cameras);
  draw_import(workspace);
  if (solve_state(workspace) != SolveState::unused) {
    draw_notices(workspace.calibrate.said);
    return draw_solved_step(workspace, cameras);
  }
  draw_state(workspace, cameras);
  if (!workspace.project().cameras.empty()) draw_way_back(workspace);
  if (cameras.empty()) return;
  ImGui::BeginChild("frusta", {kViewShare * ImGui::GetContentRegionAvail().x, 0});
  draw_frusta(workspace, cameras);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("cameras");
  draw_selected(workspace);
  draw_camera_table(workspace, cameras);
  ImGui::EndChild();
}

}  // namespace bosk
