#include "core/project/camera_wheel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/number_text.h"
#include "core/project/calibration_figures.h"
#include "core/project/html.h"
#include "core/project/reshoot.h"
#include "core/project/svg_labels.h"

namespace bosk {
namespace {

constexpr double kHalfSidePx = 360.0, kMarginPx = 70.0;
constexpr double kSightPx = 26.0;  // length of a line of sight
constexpr double kTextPx = 12.0;
constexpr double kEllipsePx = 18.0;  // what the largest error is drawn as
constexpr std::array kEnlargements = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000};

constexpr const char* kPlaced = "#1b7f3b";
constexpr const char* kUncertain = "#c77700";
constexpr const char* kReshoot = "#c4161c";

std::string number(double value) { return number_text(value, 1); }

// The world from above in pixels of the picture: x to the right, y up, the trunk in the middle.
struct Plan {
  double px_per_unit = 1.0;
  double enlargement = 1.0;  // of ellipses

  glm::dvec2 place(const glm::dvec2& in_world) const {
    return {px_per_unit * in_world.x, -px_per_unit * in_world.y};
  }
};

// Half axes along the eigenvectors of the covariance in the plane, the longer first.
struct Ellipse {
  double longer = 0.0, shorter = 0.0;
  double heading = 0.0;  // of the longer, from x towards y
};

Ellipse ellipse_of(const glm::dmat3& covariance) {
  const double xx = covariance[0][0], xy = covariance[0][1], yy = covariance[1][1];
  const double middle = 0.5 * (xx + yy), half = std::hypot(0.5 * (xx - yy), xy);
  return {std::sqrt(std::max(0.0, middle + half)), std::sqrt(std::max(0.0, middle - half)),
          0.5 * std::atan2(2.0 * xy, xx - yy)};
}

double largest_reach(const Calibration& calibration, const std::vector<ReshootPlace>& places) {
  double reach = 1e-9;
  const auto take = [&](const glm::dvec2& place) {
    const double distance = glm::length(place);
    if (std::isfinite(distance)) reach = std::max(reach, distance);
  };
  for (const Camera& camera : calibration.cameras) take(glm::dvec2(camera.centre_in_world()));
  for (const ReshootPlace& place : places) take(place.in_world);
  return reach;
}

// A round number by which the largest error ellipse becomes visible.
double enlargement_for(const Calibration& calibration, double px_per_unit) {
  double largest = 0.0;
  for (const PhotoFinding& photo : calibration.photos) {
    largest = std::max(largest, ellipse_of(photo.centre_covariance_m2).longer);
  }
  double chosen = 1.0;
  for (const int factor : kEnlargements) {
    if (largest * px_per_unit * factor <= kEllipsePx) chosen = factor;
  }
  return chosen;
}

std::string circle(const glm::dvec2& at, double radius, const std::string& look) {
  return "<circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"" + number(radius) +
         "\" " + look + "/>";
}

std::string line(const glm::dvec2& from, const glm::dvec2& to, const std::string& look) {
  return "<line x1=\"" + number(from.x) + "\" y1=\"" + number(from.y) + "\" x2=\"" + number(to.x) +
         "\" y2=\"" + number(to.y) + "\" " + look + "/>";
}

std::string words(const glm::dvec2& at, const std::string& text, const std::string& look) {
  return "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" " + look + ">" +
         html_text(text) + "</text>";
}

std::string ellipse_svg(const Ellipse& ellipse, const glm::dvec2& at, const Plan& plan) {
  const double scale = plan.px_per_unit * plan.enlargement;
  return "<ellipse rx=\"" + number(scale * ellipse.longer) + "\" ry=\"" +
         number(scale * ellipse.shorter) + "\" transform=\"translate(" + number(at.x) + " " +
         number(at.y) + ") rotate(" + number(-ellipse.heading * 180.0 / glm::pi<double>()) +
         ")\" fill=\"#4477cc\" fill-opacity=\".3\" stroke=\"#4477cc\"/>";
}

const PhotoFinding* finding_of(const Calibration& calibration, const std::string& photo) {
  for (const PhotoFinding& finding : calibration.photos) {
    if (finding.photo == photo) return &finding;
  }
  return nullptr;
}

std::string camera_svg(const Camera& camera, const PhotoFinding* finding, const Plan& plan) {
  const glm::dvec2 at = plan.place(glm::dvec2(camera.centre_in_world()));
  const glm::dvec3 axis = inverse(camera.camera_from_world).rotation * glm::dvec3(0, 0, 1);
  const glm::dvec2 sight = kSightPx * glm::dvec2(axis.x, -axis.y);
  const bool uncertain = finding != nullptr && finding->fate == PhotoFate::uncertain;
  const std::string colour = uncertain ? kUncertain : kPlaced;
  const glm::dvec2 outside = at * (1.0 + 24.0 / std::max(1.0, glm::length(at)));
  std::string svg = line(at, at + sight, "stroke=\"" + colour + "\" stroke-width=\"2\"");
  if (finding != nullptr) svg += ellipse_svg(ellipse_of(finding->centre_covariance_m2), at, plan);
  svg += circle(at, 4.0, "fill=\"" + colour + "\"");
  return svg + words(outside, camera.name, "text-anchor=\"middle\"") + "\n";
}

// Names where there is room for them: printed markers stand close together. A stick's foot lies
// under its ball.
std::string markers_svg(const Calibration& calibration, const Plan& plan) {
  std::string svg;
  std::vector<SvgLabel> labels;
  for (const SolvedPoint& point : calibration.points) {
    if (is_feature(point.name) || is_foot(point.name)) continue;
    const glm::dvec2 at = plan.place(glm::dvec2(point.in_world));
    svg += circle(at, 5.0, "fill=\"#fff\" stroke=\"#333\" stroke-width=\"2\"") + "\n";
    labels.push_back({at, point.name, "#333"});
  }
  const glm::dvec2 half(kHalfSidePx);
  return svg + svg_labels(labels, kTextPx, 8.0, -half, half);
}

std::string reshoot_svg(const ReshootPlace& place, const Plan& plan) {
  const glm::dvec2 at = plan.place(place.in_world);
  return "<g>" +
         circle(at, 11.0,
                "fill=\"none\" stroke-dasharray=\"4 3\" stroke-width=\"2\" stroke=\"" +
                    std::string(kReshoot) + "\"") +
         words(at + glm::dvec2(0, -16), "re-shoot here",
               "text-anchor=\"middle\" fill=\"" + std::string(kReshoot) + "\"") +
         "<title>" + html_text(place.why) + "</title></g>\n";
}

}  // namespace

std::string camera_wheel_svg(const Calibration& calibration) {
  const std::vector<ReshootPlace> places = reshoot_places(calibration);
  Plan plan;
  plan.px_per_unit = (kHalfSidePx - kMarginPx) / largest_reach(calibration, places);
  plan.enlargement = enlargement_for(calibration, plan.px_per_unit);
  const std::string half = number(-kHalfSidePx), side = number(2.0 * kHalfSidePx);
  std::string svg = "<svg viewBox=\"" + half + " " + half + " " + side + " " + side +
                    "\" style=\"max-width:720px\" font-size=\"" + number(kTextPx) + "\">\n" +
                    circle({0, 0}, 7.0, "fill=\"#7a5230\"") + "\n";
  svg += markers_svg(calibration, plan);
  for (const Camera& camera : calibration.cameras) {
    svg += camera_svg(camera, finding_of(calibration, camera.name), plan);
  }
  for (const ReshootPlace& place : places) svg += reshoot_svg(place, plan);
  return svg +
         words({-kHalfSidePx + 8, kHalfSidePx - 10},
               "error ellipses (one sigma) enlarged " + number_text(plan.enlargement, 0) + " times",
               "fill=\"#4477cc\"") +
         "</svg>\n";
}

}  // namespace bosk
