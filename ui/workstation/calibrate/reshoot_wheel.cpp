#include <imgui.h>

#include <algorithm>

#include "core/project/reshoot.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/calibrate/calibrate_panels.h"
#include "ui/workstation/photos/wheel_picture.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr float kListShare = 0.35f;  // of the width

void draw_list(const CameraWheel& wheel, const std::vector<ReshootPlace>& places) {
  paragraph(words_of(wheel) + ".");
  if (places.empty()) paragraph(Tone::good, "Nothing needs to be taken again.");
  for (std::size_t i = 0; i < places.size(); ++i) {
    paragraph(Tone::note, std::to_string(i + 1) + ". Re-shoot here: " + places[i].why + ".");
    mark("calibrate/reshoot/" + std::to_string(i));
  }
}

std::vector<WheelPin> pins_of(const std::vector<ReshootPlace>& places, const glm::dvec3& middle) {
  std::vector<WheelPin> pins;
  for (std::size_t i = 0; i < places.size(); ++i) {
    pins.push_back(
        {places[i].in_world - glm::dvec2(middle), "re-shoot here (" + std::to_string(i + 1) + ")"});
  }
  return pins;
}

}  // namespace

void draw_reshoot_wheel(Workspace& workspace) {
  const std::vector<Camera> cameras = photo_cameras(workspace);
  const auto calibration = workspace.calibrate.solved.calibration;
  if (cameras.empty() || !calibration) {
    return paragraph(Tone::muted, "No photo has a camera yet.");
  }
  const glm::dvec3 middle = middle_of(cameras);
  const CameraWheel wheel = wheel_of(cameras, middle);
  const std::vector<ReshootPlace> places = reshoot_places(*calibration);
  ImGui::BeginChild("reshoots", {kListShare * ImGui::GetContentRegionAvail().x, 0.0f});
  draw_list(wheel, places);
  ImGui::EndChild();
  ImGui::SameLine();
  CalibrateStepState& state = workspace.calibrate;
  const ImVec2 area = ImGui::GetContentRegionAvail();
  const WheelHand hand =
      draw_wheel("calibrate/wheel", "calibrate/spoke/", wheel, {}, pins_of(places, middle),
                 std::min(area.x, area.y), state.pointed_at);
  state.pointed_at = hand.pointed_at.value_or("");
  if (hand.clicked.empty()) return;
  show_on_canvas(workspace, hand.clicked);
  state.shown = CalibrateView::photo;
}

}  // namespace bosk
