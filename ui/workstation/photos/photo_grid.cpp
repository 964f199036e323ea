#include <imgui.h>

#include <algorithm>

#include "ui/widgets/fitted_picture.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kTileEms = 12.0f, kPictureEms = 8.5f;
constexpr float kTextLines = 4.0f;  // name, verdict, two lines of reason

ImVec2 sum(const ImVec2& a, const ImVec2& b) { return {a.x + b.x, a.y + b.y}; }

// Name, verdict and reason below the picture; what is too long is cut and stands in the tooltip.
void draw_words(const PhotoRow& row, const ImVec2& at, const ImVec2& most) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  ImGui::PushClipRect(at, most, true);
  draw.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), row.name.c_str());
  ImGui::SetCursorScreenPos({at.x, at.y + line});
  badge(row.tone, row.word);
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x, at.y + 2.0f * line},
               ImGui::GetColorU32(ImGuiCol_TextDisabled), row.reason.c_str(), nullptr,
               most.x - at.x);
  ImGui::PopClipRect();
}

void toggle(std::set<std::filesystem::path>& chosen, const std::filesystem::path& photo) {
  if (!chosen.insert(photo).second) chosen.erase(photo);
}

void draw_ground(const Workspace& workspace, const PhotoRow& row, const ImVec2& least,
                 const ImVec2& most) {
  const bool pointed_at = workspace.photos.pointed_at == row.name;
  const bool chosen = workspace.photos.chosen.contains(row.photo);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (chosen) draw.AddRectFilled(least, most, ImGui::GetColorU32(ImGuiCol_Header), 3.0f);
  if (pointed_at) draw.AddRect(least, most, colour_u32(Tone::busy), 3.0f, 0, 2.0f);
}

void draw_tile(Workspace& workspace, const PhotoRow& row, const ImVec2& size) {
  PhotosStepState& state = workspace.photos;
  const float em = ImGui::GetFontSize(), pad = 0.25f * em;
  const ImVec2 least = ImGui::GetCursorScreenPos(), most = sum(least, size);
  ImGui::PushID(row.photo.string().c_str());
  ImGui::BeginGroup();
  const bool clicked = ImGui::InvisibleButton("tile", size);
  ImGui::SetItemAllowOverlap();
  mark("photos/tile/" + row.name);
  if (ImGui::IsItemHovered()) state.pointed_at = row.name;
  tooltip(row.file.string() + "\n" + row.word + ": " + row.reason);
  draw_ground(workspace, row, least, most);
  const Texture thumbnail = thumbnail_of(workspace, row.file);
  const ImVec2 picture(size.x - 2.0f * pad, kPictureEms * em);
  draw_fitted(thumbnail, {least.x + pad, least.y + pad}, picture);
  draw_words(row, {least.x + pad, least.y + 2.0f * pad + picture.y}, {most.x - pad, most.y - pad});
  ImGui::SetCursorScreenPos({least.x + pad, least.y + pad});
  bool chosen = state.chosen.contains(row.photo);
  const bool boxed = ImGui::Checkbox("##chosen", &chosen);
  mark("photos/choose/" + row.name);
  tooltip("choose it, to remove it");
  if (boxed || (clicked && ImGui::GetIO().KeyCtrl)) {
    toggle(state.chosen, row.photo);
  } else if (clicked) {
    show_photo(workspace, row.photo);
  }
  ImGui::SetCursorScreenPos(least);
  ImGui::Dummy(size);
  ImGui::EndGroup();
  ImGui::PopID();
}

}  // namespace

void draw_photo_grid(Workspace& workspace) {
  const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 tile(kTileEms * em,
                    (kPictureEms + 1.0f) * em + kTextLines * ImGui::GetTextLineHeightWithSpacing());
  const int across = std::max(1, int((ImGui::GetContentRegionAvail().x + gap) / (tile.x + gap)));
  const auto& rows = workspace.photos.shelf.rows;
  const int lines = (int(rows.size()) + across - 1) / across;
  // A spoke of the wheel points too; a tile overrides it while the mouse is here
  if (ImGui::IsWindowHovered()) workspace.photos.pointed_at.clear();
  ImGuiListClipper clipper;
  clipper.Begin(lines, tile.y + ImGui::GetStyle().ItemSpacing.y);
  while (clipper.Step()) {
    for (int line = clipper.DisplayStart; line < clipper.DisplayEnd; ++line) {
      for (int i = line * across; i < std::min(int(rows.size()), (line + 1) * across); ++i) {
        if (i > line * across) ImGui::SameLine();
        draw_tile(workspace, rows[std::size_t(i)], tile);
      }
    }
  }
}

}  // namespace bosk
