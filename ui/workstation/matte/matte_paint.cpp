#include "ui/workstation/matte/matte_paint.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/image/orientation.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kDragDoublesPx = 80.0;  // of a right drag, on the screen
constexpr float kLeastCirclePx = 3.0f;   // of the brush's circle, on the screen

glm::dvec2 vector_of(const ImVec2& point) { return {double(point.x), double(point.y)}; }

std::optional<glm::dvec2> taken_at(const Workspace& workspace, const ImagePlace& place,
                                   const ImVec2& screen) {
  return taken_from_upright(*photo_on_canvas(workspace), orientation_on_canvas(workspace),
                            place.picture_from_screen(vector_of(screen)));
}

// Adds a place to the stroke in hand and paints what it adds.
void draw_on(Workspace& workspace, const ImagePlace& place, const ImVec2& screen) {
  Stroke& stroke = *workspace.matte.in_hand;
  const auto taken = taken_at(workspace, place, screen);
  if (!taken || stroke.points_px.size() >= kMaxStrokePoints) return;
  const glm::dvec2 kept = glm::clamp(*taken, -kMaxStrokePlacePx, kMaxStrokePlacePx);
  // As the project will keep it, so that what is painted now need not be painted again
  Stroke part = rounded_stroke({stroke.kind, stroke.radius_px, {kept}});
  if (!stroke.points_px.empty()) {
    if (stroke.points_px.back() == part.points_px.front()) return;
    part.points_px.insert(part.points_px.begin(), stroke.points_px.back());
  }
  stroke.points_px.push_back(part.points_px.back());
  paint_on_canvas(workspace, part);
}

void begin_stroke(Workspace& workspace) {
  const MatteBrush& brush = workspace.matte.brush;
  const MatteTool tool = tool_in_use(brush, ImGui::GetIO().KeyAlt);
  const double radius =
      brush.radius_of(tool) * taken_px_per_working_px(*photo_on_canvas(workspace));
  workspace.matte.in_hand = Stroke{kind_of(tool), radius, {}};
}

void hear_painting(Workspace& workspace, const ImagePlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool began = place.hovered && io.MouseClicked[ImGuiMouseButton_Left] &&
                     !ImGui::IsKeyDown(kKeySpace) && !workspace.matte.in_hand;
  if (began) begin_stroke(workspace);
  if (!workspace.matte.in_hand) return;
  for (const ImVec2& at : workspace.input.stroke_places(began)) draw_on(workspace, place, at);
  if (workspace.input.ends_stroke(began)) keep_stroke_in_hand(workspace);
}

void hear_resizing(Workspace& workspace, const ImagePlace& place) {
  MatteStepState& step = workspace.matte;
  const ImGuiIO& io = ImGui::GetIO();
  const MatteTool tool = step.brush.tool;
  if (place.hovered && io.MouseClicked[ImGuiMouseButton_Right]) {
    step.resizing = BrushResize{vector_of(io.MousePos), step.brush.radius_of(tool)};
  }
  if (!step.resizing) return;
  const double drag = double(io.MousePos.x) - step.resizing->from_screen.x;
  set_radius(step.brush, tool, step.resizing->radius_px * std::exp2(drag / kDragDoublesPx));
  if (!io.MouseDown[ImGuiMouseButton_Right]) step.resizing.reset();
}

void draw_sign(ImDrawList& draw, const ImVec2& at, MatteTool tool, float size, ImU32 colour) {
  const auto line = [&](float x, float y) {
    draw.AddLine({at.x - x, at.y - y}, {at.x + x, at.y + y}, colour, 1.5f);
  };
  if (tool == MatteTool::eraser) {
    line(size, size);
    line(size, -size);
    return;
  }
  line(size, 0.0f);
  if (tool == MatteTool::tree) line(0.0f, size);
}

}  // namespace

std::optional<glm::dvec2> taken_from_upright(const Photo& photo, int orientation,
                                             const glm::dvec2& upright_px) {
  const glm::ivec2 size(photo.camera.lens.width_px, photo.camera.lens.height_px);
  return taken_place(photo, pixel_from_upright(upright_px, size, orientation));
}

void hear_brush(Workspace& workspace, const ImagePlace& place) {
  if (!photo_on_canvas(workspace) || !strokes_obstacle(workspace).empty()) return;
  hear_resizing(workspace, place);
  hear_painting(workspace, place);
}

void draw_brush(const Workspace& workspace, const ImagePlace& place) {
  const MatteStepState& step = workspace.matte;
  if (!photo_on_canvas(workspace) || !(place.hovered || step.resizing || step.in_hand)) return;
  const MatteTool tool = tool_in_use(step.brush, ImGui::GetIO().KeyAlt);
  ImVec2 at = ImGui::GetIO().MousePos;
  if (step.resizing)
    at = {float(step.resizing->from_screen.x), float(step.resizing->from_screen.y)};
  const float radius = std::max(kLeastCirclePx, float(step.brush.radius_of(tool) * place.scale));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(place.least, place.most, true);
  const ImU32 dark = IM_COL32(0, 0, 0, 200), light = IM_COL32(255, 255, 255, 255);
  draw.AddCircle(at, radius + 1.0f, dark, 0, 3.0f);
  draw.AddCircle(at, radius, light, 0, 1.5f);
  draw_sign(draw, {at.x + 1.0f, at.y + 1.0f}, tool, 4.0f, dark);
  draw_sign(draw, at, tool, 4.0f, light);
  draw.PopClipRect();
}

void keep_stroke_in_hand(Workspace& workspace) {
  if (!workspace.matte.in_hand) return;
  Stroke stroke = std::move(*workspace.matte.in_hand);
  workspace.matte.in_hand.reset();
  if (!workspace.session || stroke.points_px.empty()) return;
  // What is painted is what will be kept
  MatteCanvas& canvas = workspace.matte.canvas;
  stroke = rounded_stroke(std::move(stroke));
  canvas.painted.push_back(stroke);
  edit(workspace, AddStroke{canvas.photo, std::move(stroke)});
}

}  // namespace bosk
