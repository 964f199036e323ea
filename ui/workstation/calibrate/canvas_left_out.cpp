#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/image/orientation.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/photo_canvas.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kLeastBrush = 0.002, kLargestBrush = 0.25;  // of the photo's longer side
constexpr double kBrushStep = 1.25;
constexpr ImU32 kVeil = IM_COL32(220, 40, 60, 110);

glm::dvec2 vector_of(const ImVec2& point) { return {double(point.x), double(point.y)}; }

double brush_px(const PhotoCanvas& canvas, const CanvasPhoto& photo) {
  return canvas.brush_share * std::max(photo.size_px.x, photo.size_px.y);
}

void draw_on(PhotoCanvas& canvas, const CanvasPhoto& photo, const ImagePlace& place,
             const ImVec2& mouse) {
  Stroke& stroke = *canvas.leaving_out;
  if (stroke.points_px.size() >= kMaxStrokePoints) return;
  const glm::dvec2 pixel = photo.delivered(place.picture_from_screen(vector_of(mouse)));
  const glm::dvec2 kept = glm::clamp(pixel, -kMaxStrokePlacePx, kMaxStrokePlacePx);
  if (stroke.points_px.empty() || stroke.points_px.back() != kept) stroke.points_px.push_back(kept);
}

void keep(Workspace& workspace) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  Stroke stroke = std::move(*canvas.leaving_out);
  canvas.leaving_out.reset();
  const PhotoRow* row = row_on_canvas(workspace);
  if (!row || stroke.points_px.empty()) return;
  edit_or_tell(workspace, AddStroke{row->name, std::move(stroke)});
}

void push_clip_to_photo(ImDrawList& draw, const CanvasPhoto& photo, const ImagePlace& place) {
  const glm::dvec2 size = upright_size(photo.size_px, photo.orientation);
  const glm::dvec2 least = place.screen_from_picture(glm::dvec2(-0.5));
  const glm::dvec2 most = place.screen_from_picture(size - 0.5);
  draw.PushClipRect(
      {std::max(place.least.x, float(least.x)), std::max(place.least.y, float(least.y))},
      {std::min(place.most.x, float(most.x)), std::min(place.most.y, float(most.y))}, true);
}

// One translucent band; a stroke of one point is a disc.
void draw_stroke(ImDrawList& draw, const Stroke& stroke, const CanvasPhoto& photo,
                 const ImagePlace& place) {
  const float radius = float(stroke.radius_px * place.scale);
  std::vector<ImVec2> line;
  for (const glm::dvec2& point : stroke.points_px) {
    const glm::dvec2 screen = place.screen_from_picture(photo.upright(point));
    line.emplace_back(float(screen.x), float(screen.y));
  }
  if (line.size() == 1) return draw.AddCircleFilled(line[0], radius, kVeil);
  draw.AddPolyline(line.data(), int(line.size()), kVeil, 0, 2.0f * radius);
}

}  // namespace

const std::vector<Stroke>* left_out_on_canvas(const Workspace& workspace) {
  const PhotoRow* row = row_on_canvas(workspace);
  const Strokes& all = workspace.project().calibration.left_out;
  const auto strokes = row ? all.find(row->name) : all.end();
  return strokes == all.end() ? nullptr : &strokes->second;
}

void hear_left_out(Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  const ImGuiIO& io = ImGui::GetIO();
  const bool began = place.hovered && io.MouseClicked[ImGuiMouseButton_Left] &&
                     !ImGui::IsKeyDown(kKeySpace) && !canvas.leaving_out;
  if (began) canvas.leaving_out = Stroke{StrokeKind::left_out, brush_px(canvas, photo), {}};
  if (!canvas.leaving_out) return;
  for (const ImVec2& at : workspace.input.stroke_places(began)) draw_on(canvas, photo, place, at);
  if (workspace.input.ends_stroke(began)) keep(workspace);
}

void resize_left_out_brush(PhotoCanvas& canvas, int steps) {
  canvas.brush_share =
      std::clamp(canvas.brush_share * std::pow(kBrushStep, steps), kLeastBrush, kLargestBrush);
}

void draw_left_out(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place) {
  const PhotoCanvas& canvas = workspace.calibrate.canvas;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  push_clip_to_photo(draw, photo, place);
  if (const auto* strokes = left_out_on_canvas(workspace)) {
    for (const Stroke& stroke : *strokes) draw_stroke(draw, stroke, photo, place);
  }
  if (canvas.leaving_out && !canvas.leaving_out->points_px.empty()) {
    draw_stroke(draw, *canvas.leaving_out, photo, place);
  }
  draw.PopClipRect();
  draw.PushClipRect(place.least, place.most, true);
  if (canvas.brush && (place.hovered || canvas.leaving_out)) {
    const float radius = float(brush_px(canvas, photo) * place.scale);
    draw.AddCircle(ImGui::GetIO().MousePos, radius + 1.0f, IM_COL32(0, 0, 0, 200), 0, 3.0f);
    draw.AddCircle(ImGui::GetIO().MousePos, radius, IM_COL32(255, 255, 255, 255), 0, 1.5f);
  }
  draw.PopClipRect();
}

void draw_left_out_tools(Workspace& workspace) {
  PhotoCanvas& canvas = workspace.calibrate.canvas;
  ImGui::Checkbox("leave out", &canvas.brush);
  mark("calibrate/leave_out");
  tooltip(
      "B: a brush for sky, clouds, people, cars: nothing is looked for where it painted; [ and ] "
      "change its size. Clicks count there too.");
  if (!left_out_on_canvas(workspace)) return;
  ImGui::SameLine();
  if (button("calibrate/use_all", "Use all", "nothing of this photo is left out any more")) {
    edit_or_tell(workspace, use_all_edit(workspace.project(), row_on_canvas(workspace)->name));
  }
}

}  // namespace bosk
