#include "ui/workstation/photos/photos_step.h"

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/named_paths.h"
#include "ui/workstation/path_field.h"
#include "ui/workstation/photos/photo_edits.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/photos/photo_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kWheelEms = 20.0f;

void draw_adding(Workspace& workspace) {
  const PathField field{"photos/path",
                        "photo or folder: type or paste its path, or drop it here",
                        "photos/add",
                        "Add",
                        "adds the photo, or all of the folder",
                        ""};
  if (const auto path = draw_path_field(field, workspace.photos.typed)) {
    take_paths(workspace, {*path});
  }
}

void draw_missing(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  const auto& rows = state.shelf.rows;
  const auto missing = std::count_if(rows.begin(), rows.end(), [&](const PhotoRow& row) {
    return state.shelf.missing.contains(row.file);
  });
  if (missing == 0) return;
  paragraph(Tone::bad, count_of(std::size_t(missing), "photo") + (missing == 1 ? " is" : " are") +
                           " missing: type where one of them is now, or their folder.");
  const PathField field{"photos/moved",
                        "where a missing photo is now",
                        "photos/find",
                        "Find",
                        "looks for all missing photos there, by their names",
                        ""};
  if (const auto path = draw_path_field(field, state.moved)) find_moved_photos(workspace, *path);
}

void choose_left_out(PhotosStepState& state) {
  state.chosen.clear();
  for (const PhotoRow& row : state.shelf.rows) {
    if (row.tone == Tone::bad) state.chosen.insert(row.photo);
  }
}

void remove_chosen(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  remove_photos(workspace, state.chosen);
  state.chosen.clear();
}

void draw_choosing(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  const auto& rows = state.shelf.rows;
  const bool any_bad = std::any_of(rows.begin(), rows.end(),
                                   [](const PhotoRow& row) { return row.tone == Tone::bad; });
  if (button("photos/choose_left_out", "Choose those left out",
             "chooses all photos that can't be used", any_bad ? "" : "none is left out")) {
    choose_left_out(state);
  }
  ImGui::SameLine();
  const std::size_t chosen = state.chosen.size();
  if (button("photos/remove", chosen == 0 ? "Remove" : "Remove " + count_of(chosen, "photo"),
             "Delete: takes them out of the project; the files stay",
             chosen == 0 ? "choose photos first, by their boxes or with Ctrl and a click" : "")) {
    remove_chosen(workspace);
  }
  ImGui::SameLine();
  if (button("photos/look_again", "Look again", "looks whether files changed, appeared or went")) {
    look_again(workspace);
  }
}

void draw_summary(const PhotosStepState& state) {
  const auto& rows = state.shelf.rows;
  const auto usable =
      std::count_if(rows.begin(), rows.end(), [](const PhotoRow& row) { return row.accepted; });
  const auto bad = std::count_if(rows.begin(), rows.end(),
                                 [](const PhotoRow& row) { return row.tone == Tone::bad; });
  const std::size_t unread = rows.size() - std::size_t(usable) - std::size_t(bad);
  std::string words = std::to_string(usable) + " of " + std::to_string(rows.size()) + " usable";
  if (bad > 0) words += ", " + std::to_string(bad) + " left out";
  if (unread > 0) words += ", " + std::to_string(unread) + " to be read";
  paragraph(unread > 0 ? Tone::busy : bad > 0 ? Tone::note : Tone::good, words + ".");
  for (const std::string& remark : state.shelf.remarks) paragraph(Tone::note, remark);
}

// Photos may have gone by undo.
void forget_gone(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  const auto& photos = workspace.project().photos;
  const auto is_gone = [&](const std::filesystem::path& photo) {
    return std::find(photos.begin(), photos.end(), photo) == photos.end();
  };
  std::erase_if(state.chosen, is_gone);
  if (is_gone(state.shown)) state.shown.clear();
}

void hear_keys(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  if (ImGui::GetIO().WantTextInput) return;
  if (workspace.input.pressed(kKeyDelete) && state.shown.empty()) remove_chosen(workspace);
}

}  // namespace

void draw_photos_step(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  const int frame = ImGui::GetFrameCount();
  if (frame > state.last_frame + 1) state.shelf.look_wanted = true;  // the step is entered
  state.last_frame = frame;
  follow_photos(workspace);
  forget_gone(workspace);
  hear_keys(workspace);
  if (!state.shown.empty()) return draw_photo_detail(workspace);
  draw_adding(workspace);
  if (!workspace.session) return;
  draw_notices(state.said);
  draw_missing(workspace);
  if (workspace.project().photos.empty()) return;
  draw_choosing(workspace);
  draw_summary(state);
  const bool wheel = !photo_cameras(workspace).empty();
  const float width = wheel ? -kWheelEms * ImGui::GetFontSize() : 0.0f;
  ImGui::BeginChild("grid", {width, 0});
  draw_photo_grid(workspace);
  ImGui::EndChild();
  if (!wheel) return;
  ImGui::SameLine();
  ImGui::BeginChild("wheel", {0, 0});
  draw_camera_wheel(workspace);
  ImGui::EndChild();
}

}  // namespace bosk
