#include <cstdio>

#include "core/geometry/label_places.h"
#include "core/project/calibration_figures.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/calibrate/calibration_words.h"
#include "ui/workstation/calibrate/error_ellipse.h"
#include "ui/workstation/calibrate/frusta_scene.h"
#include "ui/workstation/calibrate/point_colours.h"

namespace bosk {
namespace {

constexpr float kDiscPx = 4.0f, kFeaturePx = 1.0f;
constexpr double kLabelGapPx = 6.0;
constexpr ImU32 kLabelShadow = IM_COL32(0, 0, 0, 200);  // readable over photos

void draw_ellipsoid(const FrustaScene& scene, const glm::dvec3& at, const glm::dmat3& covariance_m2,
                    double factor, ImU32 line, ImU32 fill) {
  const auto outline = seen_ellipse(scene.eye, at, covariance_m2, factor);
  if (!outline) return;
  std::vector<ImVec2> points;
  for (const glm::dvec2& each : *outline) points.push_back(scene.on_screen(each));
  scene.draw->AddConvexPolyFilled(points.data(), int(points.size()), fill);
  scene.draw->AddPolyline(points.data(), int(points.size()), line, ImDrawFlags_Closed, 1.5f);
}

void draw_feature(const FrustaScene& scene, const SolvedPoint& point) {
  const auto seen = seen_line(scene.eye, point.in_world, point.in_world);
  const ImU32 colour = colour_u32(Tone::busy, 0.6f);
  if (seen) scene.draw->AddCircleFilled(scene.on_screen(seen->first), kFeaturePx, colour, 4);
}

void draw_point(const FrustaScene& scene, const SolvedPoint& point, double factor) {
  if (is_feature(point.name)) return draw_feature(scene, point);
  const glm::vec3 c = colour_of_point(point.name);
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1.0f});
  draw_ellipsoid(scene, point.in_world, point.covariance_m2, factor, colour,
                 ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 0.25f}));
  const auto seen = seen_line(scene.eye, point.in_world, point.in_world);
  if (!seen) return;
  const ImVec2 at = scene.on_screen(seen->first);
  scene.draw->AddCircleFilled(at, kDiscPx, colour);
  scene.text(point.in_world, colour, point.name);
  if (scene.shows(at)) mark("calibrate/solved/" + point.name, at, at);
}

void draw_centre(const FrustaScene& scene, const Camera& camera, const PhotoFinding& photo,
                 double factor) {
  const Tone tone = photo.fate == PhotoFate::placed ? Tone::busy : tone_of(photo.fate);
  draw_ellipsoid(scene, camera.centre_in_world(), photo.centre_covariance_m2, factor,
                 colour_u32(tone), colour_u32(tone, 0.3f));
  if (photo.fate == PhotoFate::placed) return;
  scene.text(camera.centre_in_world(), colour_u32(tone),
             photo.photo + ": " + fate_words(photo.fate), true);
}

const PhotoFinding* finding_of(const Calibration& calibration, const std::string& name) {
  for (const PhotoFinding& photo : calibration.photos) {
    if (photo.photo == name) return &photo;
  }
  return nullptr;
}

}  // namespace

void FrustaScene::line(const glm::dvec3& from, const glm::dvec3& to, ImU32 colour,
                       float width) const {
  const auto seen = seen_line(eye, from, to);
  if (seen) draw->AddLine(on_screen(seen->first), on_screen(seen->second), colour, width);
}

void FrustaScene::text(const glm::dvec3& at, ImU32 colour, const std::string& words,
                       bool needed) const {
  const auto seen = seen_line(eye, at, at);
  if (seen) labels->push_back({on_screen(seen->first), colour, words, needed});
}

void draw_labels(const FrustaScene& scene) {
  std::vector<PointLabel> wanted;
  for (const SceneLabel& label : *scene.labels) {
    const ImVec2 size = ImGui::CalcTextSize(label.words.c_str());
    wanted.push_back({{label.at.x, label.at.y}, {size.x, size.y}, label.needed});
  }
  const auto places = label_places(wanted, kLabelGapPx, {scene.least.x, scene.least.y},
                                   {scene.most.x, scene.most.y});
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const SceneLabel& label = (*scene.labels)[i];
    const ImVec2 place(float(places[i]->x), float(places[i]->y));
    scene.draw->AddText({place.x + 1.0f, place.y + 1.0f}, kLabelShadow, label.words.c_str());
    scene.draw->AddText(place, label.colour, label.words.c_str());
    mark("calibrate/label/" + label.words, place,
         {place.x + float(wanted[i].size.x), place.y + float(wanted[i].size.y)});
  }
}

void draw_error_bars(const FrustaScene& scene, const Calibration& calibration, double wanted_m) {
  std::vector<glm::dmat3> covariances;
  for (const PhotoFinding& photo : calibration.photos) {
    covariances.push_back(photo.centre_covariance_m2);
  }
  const double factor = exaggeration_for(covariances, wanted_m);
  for (const Camera& camera : calibration.cameras) {
    const PhotoFinding* photo = finding_of(calibration, camera.name);
    if (photo) draw_centre(scene, camera, *photo, factor);
  }
  // Feet last: where not all names have room, the balls above them tell which they are
  for (const bool feet : {false, true}) {
    for (const SolvedPoint& point : calibration.points) {
      if (is_foot(point.name) == feet) draw_point(scene, point, factor);
    }
  }
  char words[96];
  std::snprintf(words, sizeof words, "error bars: one sigma, drawn %g times as large", factor);
  scene.draw->AddText({scene.least.x + 8.0f, scene.least.y + 4.0f},
                      ImGui::GetColorU32(ImGuiCol_Text), words);
}

}  // namespace bosk
