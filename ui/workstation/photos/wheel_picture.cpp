#include "ui/workstation/photos/wheel_picture.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"

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

void draw_arc(const WheelPlace& place, const WheelArc& arc) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const int steps = std::max(2, int(arc.size / 6.283 * kArcSteps));
  for (int i = 0; i <= steps; ++i) {
    draw.PathLineTo(place.on_ring(arc.start + arc.size * i / steps, 1.0f));
  }
  draw.PathStroke(colour_u32(Tone::note), 0, 4.0f);
  const ImVec2 size = ImGui::CalcTextSize(arc.words.c_str());
  const ImVec2 at = place.on_ring(arc.start + 0.5 * arc.size, 0.6f);
  draw.AddText({at.x - 0.5f * size.x, at.y - 0.5f * size.y}, colour_u32(Tone::note),
               arc.words.c_str());
}

void draw_pin(const WheelPlace& place, const WheelPin& pin) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_u32(Tone::note);
  const ImVec2 at = place.at(pin.place_m);
  draw.AddCircle(at, 10.0f, colour, 0, 3.0f);
  const ImVec2 size = ImGui::CalcTextSize(pin.words.c_str());
  // On the inner side, where there is room
  const float x = at.x > place.middle.x ? at.x - size.x - 14.0f : at.x + 14.0f;
  draw.AddText({x, at.y - 0.5f * size.y}, colour, pin.words.c_str());
}

// A dot with the view's two edges before it.
void draw_spoke(const WheelPlace& place, const WheelSpoke& spoke, bool pointed_at,
                const std::string& landmark) {
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
  mark(landmark, {at.x - 4.0f, at.y - 4.0f}, {at.x + 4.0f, at.y + 4.0f});
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

}  // namespace

WheelHand draw_wheel(const std::string& name, const std::string& spokes, const CameraWheel& wheel,
                     const std::vector<WheelArc>& arcs, const std::vector<WheelPin>& pins,
                     float side, const std::string& pointed_at) {
  side = std::max(1.0f, side);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("wheel", {side, side});
  mark(name);
  WheelPlace place;
  place.middle = {least.x + 0.5f * side, least.y + 0.5f * side};
  place.radius = 0.42f * side;
  place.scale = double(place.radius) / wheel.radius_m;
  WheelHand hand;
  if (ImGui::IsItemHovered()) {
    const WheelSpoke* under = spoke_at(place, wheel, ImGui::GetIO().MousePos);
    hand.pointed_at = under ? under->name : std::string();
    if (ImGui::IsItemClicked()) hand.clicked = *hand.pointed_at;
    tooltip(*hand.pointed_at);
  }
  const std::string pointed = hand.pointed_at.value_or(pointed_at);
  draw_tree(place);
  for (const WheelArc& arc : arcs) draw_arc(place, arc);
  for (const WheelSpoke& spoke : wheel.spokes) {
    draw_spoke(place, spoke, spoke.name == pointed, spokes + spoke.name);
  }
  for (const WheelPin& pin : pins) draw_pin(place, pin);
  return hand;
}

}  // namespace bosk
