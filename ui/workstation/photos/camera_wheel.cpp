#include "ui/workstation/photos/camera_wheel.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <numbers>

namespace bosk {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Unit length, in the world.
glm::dvec3 axis_of(const Camera& camera) { return glm::row(camera.camera_from_world.rotation, 2); }

glm::dvec2 direction_or_east(const glm::dvec2& vector) {
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec2(1.0, 0.0);
}

WheelSpoke spoke_of(const Camera& camera, const glm::dvec3& middle) {
  WheelSpoke spoke;
  spoke.name = camera.name;
  spoke.place_m = glm::dvec2(camera.centre_in_world() - middle);
  spoke.looks = direction_or_east(glm::dvec2(axis_of(camera)));
  spoke.angle = std::atan2(spoke.place_m.y, spoke.place_m.x);
  if (spoke.angle < 0.0) spoke.angle += kTurn;
  return spoke;
}

}  // namespace

glm::dvec3 middle_of(std::span<const Camera> cameras) {
  // Distances to the axes: sum of (I - d d') (x - c) over all is 0
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (const Camera& camera : cameras) {
    const glm::dvec3 axis = axis_of(camera);
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(axis, axis);
    normal += across;
    right += across * camera.centre_in_world();
  }
  // 0 where all axes are parallel, 1/4 where they come from all around
  const double count = double(cameras.size());
  const double spread = glm::determinant(normal) / std::max(1.0, count * count * count);
  return spread > 1e-6 ? glm::inverse(normal) * right : glm::dvec3(0.0);
}

CameraWheel wheel_of(std::span<const Camera> cameras, const glm::dvec3& middle) {
  CameraWheel wheel;
  double radius = 0.0;
  for (const Camera& camera : cameras) {
    wheel.spokes.push_back(spoke_of(camera, middle));
    radius = std::max(radius, glm::length(wheel.spokes.back().place_m));
  }
  if (radius > 0.0) wheel.radius_m = radius;
  std::stable_sort(wheel.spokes.begin(), wheel.spokes.end(),
                   [](const auto& a, const auto& b) { return a.angle < b.angle; });
  for (std::size_t i = 0; i < wheel.spokes.size(); ++i) {
    const bool last = i + 1 == wheel.spokes.size();
    const WheelSpoke &from = wheel.spokes[i], &to = wheel.spokes[last ? 0 : i + 1];
    wheel.gaps.push_back(
        {from.name, to.name, from.angle, to.angle - from.angle + (last ? kTurn : 0.0)});
  }
  return wheel;
}

std::optional<WheelGap> widest_gap(const CameraWheel& wheel) {
  const auto widest =
      std::max_element(wheel.gaps.begin(), wheel.gaps.end(),
                       [](const auto& a, const auto& b) { return a.size < b.size; });
  if (widest == wheel.gaps.end()) return std::nullopt;
  return *widest;
}

std::string words_of(const CameraWheel& wheel) {
  const auto gap = widest_gap(wheel);
  if (!gap) return "no photo has a camera";
  const long degrees = std::lround(gap->size * 360.0 / kTurn);
  const std::string count = std::to_string(wheel.spokes.size());
  if (wheel.spokes.size() == 1) return "1 photo, from one side only";
  return count + " photos; the widest gap is " + std::to_string(degrees) + " degrees, from " +
         gap->from + " to " + gap->to;
}

}  // namespace bosk
