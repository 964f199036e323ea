#include <imgui.h>

#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/loupe.h"
#include "ui/workstation/calibrate/photo_canvas.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kSide = 17;  // pixels of the picture
constexpr float kCellPx = 10.0f;
constexpr float kMarginPx = 8.0f;

// The corner that the mouse is not in.
ImVec2 corner_of(const ImagePlace& place, const ImVec2& mouse) {
  const bool left = mouse.x > 0.5f * (place.least.x + place.most.x);
  return {left ? place.least.x + kMarginPx : place.most.x - kSide * kCellPx - kMarginPx,
          place.least.y + kMarginPx};
}

void draw_cells(ImDrawList& draw, const Image<glm::u8vec4>& cells, const ImVec2& least) {
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const glm::u8vec4& c = cells(x, y);
      const ImVec2 cell(least.x + float(x) * kCellPx, least.y + float(y) * kCellPx);
      draw.AddRectFilled(cell, {cell.x + kCellPx, cell.y + kCellPx}, IM_COL32(c.r, c.g, c.b, c.a));
    }
  }
}

// Lines through the place; `at_px` lies in the cell in the middle.
void draw_cross(ImDrawList& draw, const glm::dvec2& at_px, const ImVec2& least,
                const ImVec2& most) {
  const glm::dvec2 within = (at_px - glm::round(at_px) + 0.5 * kSide) * double(kCellPx);
  const ImVec2 cross(least.x + float(within.x), least.y + float(within.y));
  const ImU32 light = IM_COL32(255, 255, 255, 180);
  draw.AddLine({cross.x, least.y}, {cross.x, most.y}, light);
  draw.AddLine({least.x, cross.y}, {most.x, cross.y}, light);
}

}  // namespace

void draw_loupe(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place) {
  const PhotoCanvas& canvas = workspace.calibrate.canvas;
  if (!canvas.loupe || canvas.brush || !(place.hovered || canvas.held) || !canvas.large.picture) return;
  const Image<glm::u8vec4>& picture = *canvas.large.picture;
  const glm::dvec2 upright = canvas.held ? photo.upright(canvas.held->pixel) : place.mouse_px();
  // The picture may be a reduced copy of the photo
  const glm::dvec2 scale = glm::dvec2(picture.width(), picture.height()) / place.size_px;
  const glm::dvec2 at_px = (upright + 0.5) * scale - 0.5;
  const ImVec2 least = corner_of(place, ImGui::GetIO().MousePos);
  const ImVec2 most(least.x + kSide * kCellPx, least.y + kSide * kCellPx);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(least, most, IM_COL32(0, 0, 0, 255));
  draw_cells(draw, loupe_of(picture, at_px, kSide), least);
  draw_cross(draw, at_px, least, most);
  draw.AddRect(least, most, ImGui::GetColorU32(ImGuiCol_Border), 0.0f, 0, 2.0f);
  mark("calibrate/loupe_picture", least, most);
}

}  // namespace bosk
