#include <imgui.h>

#include <algorithm>

#include "core/geometry/label_places.h"
#include "core/project/calibration_figures.h"
#include "ui/widgets/landmarks.h"
#include "ui/workstation/calibrate/photo_canvas.h"
#include "ui/workstation/calibrate/point_colours.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace {

constexpr double kErrorZoom = 20.0;  // residuals are drawn that much enlarged
constexpr float kCrossPx = 7.0f, kFeaturePx = 1.5f;
constexpr ImU32 kDark = IM_COL32(0, 0, 0, 200);

ImVec2 point_of(const glm::dvec2& vector) { return {float(vector.x), float(vector.y)}; }

ImU32 colour_u32(const glm::vec3& srgb, float alpha = 1.0f) {
  return ImGui::ColorConvertFloat4ToU32({srgb.r, srgb.g, srgb.b, alpha});
}

// Everything twice, dark below: seen on any ground.
struct Pen {
  ImDrawList& draw;
  ImU32 colour;

  void line(const ImVec2& from, const ImVec2& to, float width) const {
    draw.AddLine(from, to, kDark, width + 2.0f);
    draw.AddLine(from, to, colour, width);
  }
  void circle(const ImVec2& at, float radius, float width) const {
    draw.AddCircle(at, radius, kDark, 0, width + 2.0f);
    draw.AddCircle(at, radius, colour, 0, width);
  }
  void cross(const ImVec2& at, float arm, bool upright) const {
    const float slant = upright ? 0.0f : arm;
    line({at.x - arm, at.y - slant}, {at.x + arm, at.y + slant}, 1.5f);
    line({at.x - slant, at.y + arm}, {at.x + slant, at.y - arm}, 1.5f);
  }
  void text(const ImVec2& at, const std::string& words) const {
    draw.AddText({at.x + 1.0f, at.y + 1.0f}, kDark, words.c_str());
    draw.AddText(at, colour, words.c_str());
  }
};

// Where the mark is, for a drawing that knows where the hand has it now.
glm::dvec2 pixel_now(const PhotoCanvas& canvas, const PhotoMark& each) {
  const bool held = canvas.held && canvas.held->moved && canvas.held->point == each.point;
  return held ? canvas.held->pixel : each.pixel;
}

// What isn't there for sure is faint.
float alpha_of(const PhotoMark& each) {
  const bool sure = each.kind == PhotoMark::Kind::found || each.kind == PhotoMark::Kind::by_hand;
  return sure ? 1.0f : 0.6f;
}

void draw_shape(const Pen& pen, const ImVec2& at, const PhotoMark& each, bool chosen) {
  switch (each.kind) {
    case PhotoMark::Kind::found:
      pen.cross(at, kCrossPx, true);
      pen.circle(at, kCrossPx, 1.5f);
      break;
    case PhotoMark::Kind::by_hand:
      pen.cross(at, kCrossPx, true);
      break;
    case PhotoMark::Kind::removed:
      pen.cross(at, 0.7f * kCrossPx, false);
      break;
    case PhotoMark::Kind::expected:
      pen.circle(at, 0.7f * kCrossPx, 1.0f);
      break;
  }
  if (chosen) pen.circle(at, 1.7f * kCrossPx, 2.0f);
}

void draw_mark_of(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place,
                  const PhotoMark& each) {
  const PhotoCanvas& canvas = workspace.calibrate.canvas;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const glm::dvec2 upright = photo.upright(pixel_now(canvas, each));
  const ImVec2 at = point_of(place.screen_from_picture(upright));
  if (each.is_feature) {
    return draw.AddCircleFilled(at, kFeaturePx, bosk::colour_u32(Tone::busy, 0.7f));
  }
  const Pen pen{draw, colour_u32(colour_of_point(each.point), alpha_of(each))};
  if (each.error_px) {
    const glm::dvec2 predicted = photo.upright(each.pixel + kErrorZoom * *each.error_px);
    const Pen error{draw, bosk::colour_u32(each.outlier ? Tone::bad : Tone::neutral)};
    error.line(at, point_of(place.screen_from_picture(predicted)), each.outlier ? 3.0f : 2.0f);
  }
  draw_shape(pen, at, each, each.point == canvas.point);
  mark("calibrate/mark/" + each.point, at, at);
}

// Where not all names have room: the chosen point's first, then those that need a look; feet last,
// since they stand under their balls.
int rank_of(const PhotoMark& each, const std::string& chosen) {
  if (each.point == chosen) return 0;
  if (each.outlier) return 1;
  return is_foot(each.point) ? 3 : 2;
}

void draw_names(const PhotoCanvas& canvas, const CanvasPhoto& photo, const ImagePlace& place,
                const std::vector<PhotoMark>& marks) {
  std::vector<const PhotoMark*> named;
  for (const PhotoMark& each : marks) {
    if (!each.is_feature) named.push_back(&each);
  }
  std::stable_sort(named.begin(), named.end(), [&](const PhotoMark* a, const PhotoMark* b) {
    return rank_of(*a, canvas.point) < rank_of(*b, canvas.point);
  });
  std::vector<std::string> words;
  std::vector<PointLabel> labels;
  for (const PhotoMark* each : named) {
    words.push_back(rank_of(*each, canvas.point) < 2 ? words_of(*each) : each->point);
    const ImVec2 size = ImGui::CalcTextSize(words.back().c_str());
    labels.push_back({place.screen_from_picture(photo.upright(pixel_now(canvas, *each))),
                      {double(size.x), double(size.y)},
                      rank_of(*each, canvas.point) < 2});
  }
  const auto places = label_places(labels, 1.4 * double(kCrossPx), {place.least.x, place.least.y},
                                   {place.most.x, place.most.y});
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (!places[i]) continue;
    const ImU32 colour = named[i]->outlier
                             ? bosk::colour_u32(Tone::bad)
                             : colour_u32(colour_of_point(named[i]->point), alpha_of(*named[i]));
    const Pen pen{*ImGui::GetWindowDrawList(), colour};
    const ImVec2 at = point_of(*places[i]);
    pen.text(at, words[i]);
    mark("calibrate/name/" + named[i]->point, at,
         {at.x + float(labels[i].size.x), at.y + float(labels[i].size.y)});
  }
}

// Of a chosen point that is being placed.
void draw_placed(const PhotoCanvas& canvas, const CanvasPhoto& photo, const ImagePlace& place) {
  if (!canvas.held || !canvas.pressed_on_nothing || canvas.held->point.empty()) return;
  const Pen pen{*ImGui::GetWindowDrawList(), colour_u32(colour_of_point(canvas.held->point))};
  pen.cross(point_of(place.screen_from_picture(photo.upright(canvas.held->pixel))), kCrossPx, true);
}

}  // namespace

void draw_marks(const Workspace& workspace, const CanvasPhoto& photo, const ImagePlace& place,
                const std::vector<PhotoMark>& marks) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(place.least, place.most, true);
  for (const PhotoMark& each : marks) draw_mark_of(workspace, photo, place, each);
  draw_names(workspace.calibrate.canvas, photo, place, marks);
  draw_placed(workspace.calibrate.canvas, photo, place);
  const float line = 1.5f * ImGui::GetTextLineHeight();
  const Pen pen{draw, ImGui::GetColorU32(ImGuiCol_Text)};
  pen.text({place.least.x + 8.0f, place.most.y - line},
           "circle: found, cross: by hand, x: removed, ring: expected; lines: error x 20");
  draw.PopClipRect();
}

}  // namespace bosk
