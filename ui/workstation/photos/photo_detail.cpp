#include <imgui.h>

#include <algorithm>

#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/photos/large_photo.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/photos/photo_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr float kDetailsEms = 22.0f;

void step_to(Workspace& workspace, int by) {
  const auto& rows = workspace.photos.shelf.rows;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const PhotoRow& other) {
    return other.photo == workspace.photos.shown;
  });
  const auto place = row - rows.begin() + by;
  if (place < 0 || place >= std::ssize(rows)) return;
  show_photo(workspace, rows[std::size_t(place)].photo);
}

void draw_way(Workspace& workspace) {
  const auto& rows = workspace.photos.shelf.rows;
  const bool first = rows.front().photo == workspace.photos.shown;
  const bool last = rows.back().photo == workspace.photos.shown;
  int by = 0;
  bool back = button("photos/back", "All photos", "Escape: back to the grid");
  ImGui::SameLine();
  if (button("photos/previous", "Previous", "Left", first ? "this is the first" : "")) by = -1;
  ImGui::SameLine();
  if (button("photos/next", "Next", "Right", last ? "this is the last" : "")) by = 1;
  if (!ImGui::GetIO().WantTextInput) {
    if (workspace.input.pressed(kKeyEscape)) back = true;
    if (workspace.input.pressed(kKeyLeft)) by = -1;
    if (workspace.input.pressed(kKeyRight)) by = 1;
  }
  if (by != 0) step_to(workspace, by);
  if (back) workspace.photos.shown.clear();
}

void draw_details(const PhotoRow& row, const ShelvedPhoto& photo) {
  ImGui::TextUnformatted(row.name.c_str());
  badge(row.tone, row.word);
  paragraph(Tone::muted, row.reason);
  ImGui::Separator();
  if (photo.facts.trouble.empty() && ImGui::BeginTable("details", 2)) {
    for (const auto& [name, value] : details_of(photo.facts, photo.stamp.bytes)) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", name.c_str());
      ImGui::TableNextColumn();
      paragraph(value);
    }
    ImGui::EndTable();
  }
  ImGui::Separator();
  paragraph(Tone::muted, row.file.string());
}

}  // namespace

void show_photo(Workspace& workspace, const fs::path& photo) {
  ask_again(workspace.photos.large);
  workspace.photos.shown = photo;
  workspace.photos.view = {};
}

void draw_photo_detail(Workspace& workspace) {
  PhotosStepState& state = workspace.photos;
  const auto& rows = state.shelf.rows;
  const auto found = std::find_if(
      rows.begin(), rows.end(), [&](const PhotoRow& other) { return other.photo == state.shown; });
  if (found == rows.end()) return;
  const PhotoRow row = *found;
  draw_way(workspace);
  const ShelvedPhoto* photo = shelved(workspace, row.file);
  if (!photo || !photo->thumbnail) {
    badge(row.tone, row.word);
    return paragraph(row.name + ": " + row.reason);
  }
  follow_large(workspace, state.large, row, "large photo");
  const float width = kDetailsEms * ImGui::GetFontSize();
  const ImVec2 left = ImGui::GetContentRegionAvail();
  draw_image_view("photos/view", state.view,
                  best_picture(workspace, state.large, row, "photos/large"),
                  upright_size_of(photo->facts), {std::max(1.0f, left.x - width), left.y});
  ImGui::SameLine();
  ImGui::BeginChild("details");
  draw_details(row, *photo);
  ImGui::EndChild();
}

}  // namespace bosk
