#include "ui/widgets/camera_mouse.h"

#include <imgui.h>

#include <algorithm>

namespace bosk {

ViewCamera zoomed_by_wheel(const ViewCamera& view, const Terrain& terrain) {
  const float steps = ImGui::GetIO().MouseWheel;
  return steps == 0.0f ? view : zoomed(view, double(steps), terrain);
}

ViewCamera moved_by_drag(const ViewCamera& view, const Terrain& terrain, double height_px,
                         double view_angle) {
  const ImGuiIO& io = ImGui::GetIO();
  const glm::dvec2 delta(io.MouseDelta.x * io.DisplayFramebufferScale.x,
                         io.MouseDelta.y * io.DisplayFramebufferScale.y);
  if (delta == glm::dvec2(0.0)) return view;
  const double height = std::max(1.0, height_px);
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool pan = ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                   ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyShift);
  if (pan) return panned(view, delta, height, view_angle, terrain);
  return left ? dragged(view, delta, height, terrain) : view;
}

}  // namespace bosk
