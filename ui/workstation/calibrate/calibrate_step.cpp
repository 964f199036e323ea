#include "ui/workstation/calibrate/calibrate_step.h"

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/calibrate/camera_import.h"
#include "ui/workstation/calibrate/camera_measures.h"
#include "ui/workstation/path_field.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kViewShare = 0.58f;  // of the width

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
  const std::vector<Camera> cameras = photo_cameras(workspace);
  forget_gone(workspace.calibrate, cameras);
  draw_import(workspace);
  draw_state(workspace, cameras);
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
