#include "ui/widgets/image_view.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"

namespace bosk {
namespace {

constexpr double kZoomOfStep = 1.25;  // of the wheel

glm::dvec2 vector_of(const ImVec2& point) { return {double(point.x), double(point.y)}; }
ImVec2 point_of(const glm::dvec2& vector) { return {float(vector.x), float(vector.y)}; }

ImageView kept_inside(ImageView view) {
  view.zoom = std::clamp(view.zoom, 1.0, kMostZoom);
  const double margin = 0.5 / view.zoom;
  view.middle = glm::clamp(view.middle, glm::dvec2(margin), glm::dvec2(1.0 - margin));
  return view;
}

bool is_panning() {
  return ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f) ||
         (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0.0f) && ImGui::IsKeyDown(kKeySpace));
}

void hear(ImageView& view, const ImagePlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel != 0.0f) {
    const double factor = std::pow(kZoomOfStep, double(io.MouseWheel));
    view = zoomed(view, place, place.mouse_px(), factor);
  }
  if (is_panning()) {
    view.middle -= vector_of(io.MouseDelta) / (place.size_px * place.scale);
    view = kept_inside(view);
  }
  if (ImGui::IsKeyPressed(kKeyHome) && !io.WantTextInput) view = {};
}

}  // namespace

glm::dvec2 ImagePlace::mouse_px() const {
  return picture_from_screen(vector_of(ImGui::GetIO().MousePos));
}

ImagePlace place_of(const ImageView& view, const glm::dvec2& size_px, const ImVec2& least,
                    const ImVec2& most) {
  ImagePlace place;
  place.least = least;
  place.most = most;
  place.size_px = glm::max(size_px, glm::dvec2(1.0));
  const glm::dvec2 area = glm::max(vector_of(most) - vector_of(least), glm::dvec2(1.0));
  place.scale = view.zoom * std::min(area.x / place.size_px.x, area.y / place.size_px.y);
  const glm::dvec2 middle = 0.5 * (vector_of(least) + vector_of(most));
  place.origin = middle - view.middle * place.size_px * place.scale;
  return place;
}

ImageView zoomed(const ImageView& view, const ImagePlace& place, const glm::dvec2& at_px,
                 double factor) {
  const double zoom = std::clamp(view.zoom * factor, 1.0, kMostZoom);
  const glm::dvec2 at = (at_px + 0.5) / place.size_px;
  return kept_inside({zoom, at + (view.middle - at) * (view.zoom / zoom)});
}

ImagePlace draw_image_view(const std::string& name, ImageView& view, const Texture& texture,
                           const glm::dvec2& size_px, ImVec2 area) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  if (area.x <= 0.0f) area.x = std::max(1.0f, left.x);
  if (area.y <= 0.0f) area.y = std::max(1.0f, left.y);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const ImVec2 most(least.x + area.x, least.y + area.y);
  ImGui::InvisibleButton(name.c_str(), area, 7);  // all three buttons
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  mark(name);
  ImagePlace place = place_of(view, size_px, least, most);
  if (hovered) hear(view, place);
  place = place_of(view, size_px, least, most);
  place.hovered = hovered;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(least, most, true);
  if (texture) {
    draw.AddImage(texture.id, point_of(place.origin),
                  point_of(place.origin + place.size_px * place.scale));
  }
  draw.PopClipRect();
  return place;
}

}  // namespace bosk
