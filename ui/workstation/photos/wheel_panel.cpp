#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/landmarks.h"
#include "ui/workstation/photos/camera_wheel.h"
#include "ui/workstation/photos/photo_panels.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr int kArcSteps = 48;      // of a full turn
constexpr float kReachPx = 12.0f;  // of the mouse to a spoke

// The wheel as it lies on the screen: north (y) up.
struct WheelPlace {
  ImVec2 middle{0, 0};
  float radius = 1.0f;  // of the farthest spoke
  double scale = 1.0;   // screen points a metre

  ImVec2 at(const glm::dvec2& place_m) const {
    return {middle.x + float(scale * place_m.x), middle.y - float(scale * place_m.y)};
  }
  ImVec2 on_ring(double angle, float share) const {
    return {middle.x + share * radius * float(std::cos(angle)),
            middle.y - share * radius * float(std::sin(angle))};
  }
};

void draw_gap(const WheelPlace& place, const WheelGap& gap) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const int steps = std::max(2, int(gap.size / 6.283 * kArcSteps));
  for (int i = 0; i <= steps; ++i) {
    draw.PathLineTo(place.on_ring(gap.start + gap.size * i / steps, 1.0f));
  }
  draw.PathStroke(colour_u32(Tone::note), 0, 4.0f);
  const char* words = "no photo\nfrom here";
  const ImVec2 size = ImGui::CalcTextSize(words);
  const ImVec2 at = place.on_ring(gap.start + 0.5 * gap.size, 0.6f);
  draw.AddText({at.x - 0.5f * size.x, at.y - 0.5f * size.y}, colour_u32(Tone::note), words);
}

// A dot with the view's two edges before it.
void draw_spoke(const WheelPlace& place, const WheelSpoke& spoke, bool pointed_at) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_u32(pointed_at ? Tone::busy : Tone::neutral);
  const ImVec2 at = place.at(spoke.place_m);
  const float length = pointed_at ? 26.0f : 16.0f;
  const double angle = std::atan2(spoke.looks.y, spoke.looks.x);
  ImVec2 ends[2];
  for (int i = 0; i < 2; ++i) {
    const double edge = angle + (i == 0 ? -0.35 : 0.35);
    ends[i] = {at.x + length * float(std::cos(edge)), at.y - length * float(std::sin(edge))};
  }
  draw.AddTriangleFilled(at, ends[0], ends[1], colour_u32(Tone::busy, pointed_at ? 0.7f : 0.3f));
  draw.AddCircleFilled(at, pointed_at ? 6.0f : 4.0f, colour);
  mark("photos/spoke/" + spoke.name, {at.x - 4.0f, at.y - 4.0f}, {at.x + 4.0f, at.y + 4.0f});
}

// The spoke that the mouse is on; null: none.
const WheelSpoke* spoke_at(const WheelPlace& place, const CameraWheel& wheel, const ImVec2& mouse) {
  const WheelSpoke* nearest = nullptr;
  float least = kReachPx;
  for (const WheelSpoke& spoke : wheel.spokes) {
    const ImVec2 at = place.at(spoke.place_m);
    const float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
    if (distance >= least) continue;
    least = distance;
    nearest = &spoke;
  }
  return nearest;
}

void draw_tree(const WheelPlace& place) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircle(place.middle, place.radius, ImGui::GetColorU32(ImGuiCol_Border), 96);
  draw.AddCircleFilled(place.middle, 0.1f * place.radius, colour_u32(Tone::good, 0.6f));
}

void hear_wheel(Workspace& workspace, const WheelPlace& place, const CameraWheel& wheel) {
  const WheelSpoke* spoke = spoke_at(place, wheel, ImGui::GetIO().MousePos);
  workspace.photos.pointed_at = spoke ? spoke->name : std::string();
  if (!spoke) return;
  tooltip(spoke->name);
  const PhotoRow* row = row_of(workspace, spoke->name);
  if (row && ImGui::IsItemClicked()) show_photo(workspace, row->photo);
}

}  // namespace

void draw_camera_wheel(Workspace& workspace) {
  const std::vector<Camera> cameras = photo_cameras(workspace);
  const CameraWheel wheel = wheel_of(cameras, middle_of(cameras));
  const auto gap = widest_gap(wheel);
  const bool wide = gap && gap->size > kWideGap;
  ImGui::TextUnformatted("From above");
  badge(wide ? Tone::note : Tone::good, wide ? "gaps" : "from all around");
  paragraph(words_of(wheel) + ".");
  const float side = std::max(1.0f, ImGui::GetContentRegionAvail().x);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("wheel", {side, side});
  mark("photos/wheel");
  WheelPlace place;
  place.middle = {least.x + 0.5f * side, least.y + 0.5f * side};
  place.radius = 0.42f * side;
  place.scale = double(place.radius) / wheel.radius_m;
  if (ImGui::IsItemHovered()) hear_wheel(workspace, place, wheel);
  draw_tree(place);
  for (const WheelGap& each : wheel.gaps) {
    if (each.size > kWideGap) draw_gap(place, each);
  }
  for (const WheelSpoke& spoke : wheel.spokes) {
    draw_spoke(place, spoke, spoke.name == workspace.photos.pointed_at);
  }
  paragraph(Tone::muted, "Point at a camera to see which photo it is; click to open it.");
}

}  // namespace bosk
