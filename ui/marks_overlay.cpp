#include <imgui.h>

#include "ui/view_marks.h"
#include "ui/viewer_state.h"

namespace bosk {
namespace {

ImU32 colour_of(const glm::u8vec3& colour) { return IM_COL32(colour.r, colour.g, colour.b, 255); }

}  // namespace

void draw_marks(const ForestScene& scene, const Camera& camera, const ViewerState& state) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const ViewMark& mark : view_marks(scene, camera, target_of(state.camera))) {
    const ImVec2 at(float(mark.pixel.x + 0.5) / scale.x, float(mark.pixel.y + 0.5) / scale.y);
    list.AddCircleFilled(at, float(kMarkRadius) / scale.x,
                         colour_of(mark.is_mixed ? kMixedMarkColour : kMarkColour));
  }
}

}  // namespace bosk
