#include <imgui.h>

#include <algorithm>

#include "ui/widgets/fitted_picture.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/photos/photo_shelf.h"
#include "ui/workstation/photos/photo_words.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kThumbnailEms = 3.2f, kListEms = 22.0f, kSheetEms = 13.0f;

// A photo of the review in a view, as delivered.
Texture small_texture(Workspace& workspace, const SmallPhoto& photo, MatteView view) {
  static const Image<std::uint8_t> no_strokes;
  const std::uint64_t revision =
      workspace.matte.review.revision * kMatteViews + std::uint64_t(view);
  return workspace.pictures.show("matte/small/" + std::string(name_of(view)) + "/" + photo.name,
                                 revision, [&] {
                                   return picture_of(view, {photo.srgb, photo.matte, no_strokes});
                                 });
}

const MatteDoubt* doubt_of(const Workspace& workspace, const std::string& photo) {
  const auto found = workspace.matte.review.doubts.find(photo);
  return found == workspace.matte.review.doubts.end() ? nullptr : &found->second;
}

double median_doubt(const MatteReview& review) {
  std::vector<MatteDoubt> doubts;
  for (const auto& [name, doubt] : review.doubts) doubts.push_back(doubt);
  return median_doubt(doubts);
}

void draw_doubt(const Workspace& workspace, const std::string& photo, double median) {
  const MatteDoubt* doubt = doubt_of(workspace, photo);
  if (!doubt) return;
  if (!stands_out(*doubt, median)) return badge(Tone::good, "like the others");
  badge(Tone::note, "look here");
  if (!doubt->reason.empty()) paragraph(doubt->reason);
}

std::string stroke_words(std::size_t count) {
  return count == 0 ? std::string() : count_of(count, "stroke");
}

void draw_row(Workspace& workspace, const std::string& name, double median) {
  MatteStepState& step = workspace.matte;
  const float side = kThumbnailEms * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string id = "##photo/" + name;
  if (ImGui::Selectable(id.c_str(), step.photo == name, 0, {0.0f, side})) {
    step.photo = name;
    step.sheet = false;
  }
  mark("matte/photo/" + name);
  const ImVec2 next = ImGui::GetCursorScreenPos();
  if (const SmallPhoto* small = small_photo(step.review, name)) {
    draw_fitted(small_texture(workspace, *small, MatteView::photo), at, {side, side},
                orientation_of(workspace, name));
  }
  ImGui::SetCursorScreenPos({at.x + side + 0.5f * ImGui::GetFontSize(), at.y});
  ImGui::BeginGroup();
  ImGui::TextUnformatted(name.c_str());
  const std::string strokes = stroke_words(strokes_on(workspace, name).size());
  if (!strokes.empty()) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s", strokes.c_str());
  }
  draw_doubt(workspace, name, median);
  ImGui::EndGroup();
  const float below = std::max(next.y, ImGui::GetCursorScreenPos().y);
  ImGui::SetCursorScreenPos({at.x, below});
}

void draw_cell(Workspace& workspace, const SmallPhoto& photo, double median, float side) {
  MatteStepState& step = workspace.matte;
  ImGui::BeginGroup();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(("##sheet/" + photo.name).c_str(), {side, side})) {
    step.photo = photo.name;
    step.sheet = false;
  }
  mark("matte/sheet/" + photo.name);
  const bool visible = ImGui::IsItemVisible();
  if (ImGui::IsItemHovered()) {
    ImGui::GetWindowDrawList()->AddRect(at, {at.x + side, at.y + side}, colour_u32(Tone::busy));
  }
  tooltip("open " + photo.name);
  if (visible) {
    draw_fitted(small_texture(workspace, photo, step.view), at, {side, side},
                orientation_of(workspace, photo.name));
  }
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + side);
  ImGui::TextUnformatted(
      (photo.name + "  " + stroke_words(strokes_on(workspace, photo.name).size())).c_str());
  const MatteDoubt* doubt = doubt_of(workspace, photo.name);
  if (doubt && stands_out(*doubt, median)) {
    badge(Tone::note, "look here");
    if (!doubt->reason.empty()) ImGui::TextUnformatted(doubt->reason.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::EndGroup();
}

}  // namespace

void draw_matte_photos(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  ImGui::Checkbox("most in doubt first", &step.doubt_first);
  mark("matte/doubt_first");
  tooltip(
      "how far a matte is out of keeping with the others: colours that are background there, "
      "a tree that is larger or smaller; known once all photos are matted");
  const double median = median_doubt(step.review);
  ImGui::BeginChild("photos", {0.0f, kListEms * ImGui::GetFontSize()}, true);
  for (const std::string& name : photos_in_order(step.review, step.doubt_first)) {
    draw_row(workspace, name, median);
  }
  ImGui::EndChild();
}

void draw_matte_sheet(Workspace& workspace) {
  MatteStepState& step = workspace.matte;
  const float side = kSheetEms * ImGui::GetFontSize();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const int columns = std::max(1, int((ImGui::GetContentRegionAvail().x + gap) / (side + gap)));
  const double median = median_doubt(step.review);
  if (!ImGui::BeginTable("sheet", columns, ImGuiTableFlags_SizingFixedFit)) return;
  for (const std::string& name : photos_in_order(step.review, step.doubt_first)) {
    const SmallPhoto* photo = small_photo(step.review, name);
    if (!photo) continue;
    ImGui::TableNextColumn();
    draw_cell(workspace, *photo, median, side);
    if (!step.sheet) break;  // one was opened
  }
  ImGui::EndTable();
}

}  // namespace bosk
