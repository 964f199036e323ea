#include <imgui.h>

#include <algorithm>

#include "core/image/orientation.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/photos/decoder_pool.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/photos/photo_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

constexpr float kDetailsEms = 22.0f;

void install(LargePhoto& large, const fs::path& file, Image<glm::u8vec4> picture) {
  if (large.file != file) return;  // another photo was asked for meanwhile
  large.picture = std::make_shared<const Image<glm::u8vec4>>(std::move(picture));
  ++large.revision;
}

// Asks for the photo in full, once for each state of its file.
void follow_large(Workspace& workspace, const PhotoRow& row, const ShelvedPhoto& photo) {
  LargePhoto& large = workspace.photos.large;
  if (large.file == row.file && large.stamp == photo.stamp) return;
  large.file = row.file;
  large.stamp = photo.stamp;
  large.picture = nullptr;
  workspace.jobs.start(
      "Opening " + row.name,
      [decoders = workspace.photos.shelf.decoders, file = row.file,
       limits = decode_limits(workspace.project().recipe.photo)](Progress& progress) {
        progress.begin("decoding", 1);
        return large_photo(*decoders, file, limits, progress);
      },
      [&workspace, file = row.file](Image<glm::u8vec4> picture) {
        install(workspace.photos.large, file, std::move(picture));
      },
      Lane::interactive, "large photo");
}

// The full photo where it is there, else its thumbnail.
Texture best_picture(Workspace& workspace, const PhotoRow& row) {
  const LargePhoto& large = workspace.photos.large;
  if (large.file != row.file || !large.picture) return thumbnail_of(workspace, row.file);
  return workspace.pictures.show("photos/large", large.revision, [&] { return *large.picture; });
}

glm::dvec2 shown_size(const PhotoFacts& facts) {
  return upright_size({facts.decoded.width_px, facts.decoded.height_px},
                      facts.decoded.metadata.orientation);
}

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
  // One that was stopped on its way is asked for again
  if (!workspace.photos.large.picture) workspace.photos.large.file.clear();
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
  follow_large(workspace, row, *photo);
  const float width = kDetailsEms * ImGui::GetFontSize();
  const ImVec2 left = ImGui::GetContentRegionAvail();
  draw_image_view("photos/view", state.view, best_picture(workspace, row), shown_size(photo->facts),
                  {std::max(1.0f, left.x - width), left.y});
  ImGui::SameLine();
  ImGui::BeginChild("details");
  draw_details(row, *photo);
  ImGui::EndChild();
}

}  // namespace bosk
