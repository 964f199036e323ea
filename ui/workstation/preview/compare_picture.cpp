// One comparison on the screen, in the mode chosen.

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/keys.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/preview/compare_view.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

struct Sides {
  Texture photo, render;
  glm::dvec2 size_px{0.0};
};

// Both are asked for in every mode, so that changing sides costs nothing.
Sides sides_of(Workspace& workspace, const KeptComparison& kept) {
  const CompareState& state = workspace.preview.compare;
  const Comparison& comparison = *kept.comparison;
  const bool alone = state.tree_alone || comparison.photo.empty();
  Sides sides;
  sides.photo = workspace.pictures.show("preview/photo", 2 * kept.revision + (alone ? 1 : 0), [&] {
    return alone ? shown_over_white(comparison.truth) : comparison.photo;
  });
  sides.render = workspace.pictures.show("preview/render", kept.revision,
                                         [&] { return shown_over_white(comparison.render); });
  sides.size_px = {comparison.render.width(), comparison.render.height()};
  return sides;
}

ImVec2 corner(const glm::dvec2& point) { return {float(point.x), float(point.y)}; }

// The texture over what a view shows, from `left` on.
void add_over(const ImagePlace& place, const Texture& texture, float left, float opacity) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({left, place.least.y}, place.most, true);
  list.AddImage(texture.id, corner(place.origin),
                corner(place.origin + place.size_px * place.scale), {0, 0}, {1, 1},
                ImGui::ColorConvertFloat4ToU32({1.0f, 1.0f, 1.0f, opacity}));
  list.PopClipRect();
}

void write_at(const ImVec2& at, const char* text) {
  const ImVec2 size = ImGui::CalcTextSize(text);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x - 3, at.y - 1}, {at.x + size.x + 3, at.y + size.y + 1},
                     IM_COL32(20, 22, 24, 200));
  list.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), text);
}

void draw_divider(const ImagePlace& place, float x) {
  const float em = ImGui::GetFontSize();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = 0.5f * (place.least.y + place.most.y);
  list.AddLine({x, place.least.y}, {x, place.most.y}, IM_COL32(20, 22, 24, 255), 4.0f);
  list.AddLine({x, place.least.y}, {x, place.most.y}, colour_u32(Tone::busy), 2.0f);
  list.AddCircleFilled({x, middle}, 0.6f * em, colour_u32(Tone::busy));
  mark("preview/divider", {x - 0.6f * em, middle - 0.6f * em}, {x + 0.6f * em, middle + 0.6f * em});
  write_at({place.least.x + 6, place.least.y + 4}, "photo");
  write_at({place.most.x - 6 - ImGui::CalcTextSize("render").x, place.least.y + 4}, "render");
}

void draw_wipe(CompareState& state, const Sides& sides) {
  const ImagePlace place =
      draw_image_view("preview/picture", state.part, sides.photo, sides.size_px);
  const float width = std::max(1.0f, place.most.x - place.least.x);
  const bool panning = ImGui::IsKeyDown(kKeySpace);
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left) && !panning) {
    state.divider = std::clamp((ImGui::GetIO().MousePos.x - place.least.x) / width, 0.0f, 1.0f);
  }
  const float x = place.least.x + state.divider * width;
  add_over(place, sides.render, x, 1.0f);
  draw_divider(place, x);
}

void draw_side_by_side(CompareState& state, const Sides& sides) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 half(std::max(1.0f, 0.5f * (left.x - spacing)), std::max(1.0f, left.y));
  draw_image_view("preview/picture", state.part, sides.photo, sides.size_px, half);
  ImGui::SameLine();
  draw_image_view("preview/picture2", state.part, sides.render, sides.size_px, half);
}

}  // namespace

void draw_comparison(Workspace& workspace, const KeptComparison& kept) {
  CompareState& state = workspace.preview.compare;
  const Sides sides = sides_of(workspace, kept);
  switch (state.mode) {
    case CompareMode::photo:
      draw_image_view("preview/picture", state.part, sides.photo, sides.size_px);
      break;
    case CompareMode::render:
      draw_image_view("preview/picture", state.part, sides.render, sides.size_px);
      break;
    case CompareMode::wipe:
      draw_wipe(state, sides);
      break;
    case CompareMode::blend: {
      const ImagePlace place =
          draw_image_view("preview/picture", state.part, sides.photo, sides.size_px);
      add_over(place, sides.render, place.least.x, state.blend);
      break;
    }
    case CompareMode::side_by_side:
      draw_side_by_side(state, sides);
      break;
    case CompareMode::difference: {
      const Texture texture = workspace.pictures.show(
          "preview/difference", kept.revision, [&] { return shown_difference(*kept.comparison); });
      draw_image_view("preview/picture", state.part, texture, sides.size_px);
      break;
    }
  }
}

}  // namespace bosk
