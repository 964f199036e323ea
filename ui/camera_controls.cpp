#include "ui/camera_controls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bosk {
namespace {

constexpr double kNearest = 0.05;  // metres to the target of an orbit
constexpr double kFarthest = 1e5;

glm::dvec3 right_of(const ViewCamera& view) {
  return {std::sin(view.heading), -std::cos(view.heading), 0.0};
}

ViewCamera turned(ViewCamera view, double heading, double pitch) {
  view.heading = std::remainder(view.heading + heading, 2.0 * std::numbers::pi);
  view.pitch = std::clamp(view.pitch + pitch, -kSteepest, kSteepest);
  return view;
}

// Above the ground; on it when walking. An orbit goes on looking at its target.
ViewCamera above_ground(ViewCamera view, const Terrain& terrain) {
  const double ground = height_at(terrain, view.eye.x, view.eye.y);
  if (view.mode == ViewCamera::Mode::walk) {
    view.eye.z = ground + kEyeHeight;
  } else if (view.eye.z < ground + kClearance) {
    glm::dvec3 eye = view.eye;
    eye.z = ground + kClearance;
    if (view.mode == ViewCamera::Mode::orbit) return looking_at(view, eye, target_of(view));
    view.eye = eye;
  }
  return view;
}

}  // namespace

glm::dvec3 forward_of(const ViewCamera& view) {
  return {std::cos(view.pitch) * std::cos(view.heading),
          std::cos(view.pitch) * std::sin(view.heading), std::sin(view.pitch)};
}

glm::dvec3 target_of(const ViewCamera& view) { return view.eye + view.distance * forward_of(view); }

ViewCamera looking_at(const ViewCamera& view, const glm::dvec3& eye, const glm::dvec3& at) {
  ViewCamera result = view;
  result.eye = eye;
  const glm::dvec3 to_target = at - eye;
  const double across = std::hypot(to_target.x, to_target.y);
  result.distance = std::clamp(glm::length(to_target), kNearest, kFarthest);
  result.heading = across > 0.0 ? std::atan2(to_target.y, to_target.x) : 0.5 * std::numbers::pi;
  result.pitch = std::clamp(std::atan2(to_target.z, across), -kSteepest, kSteepest);
  return result;
}

ViewCamera dragged(const ViewCamera& view, const glm::dvec2& delta_px, double height_px,
                   const Terrain& terrain) {
  const glm::dvec2 angle = delta_px / height_px * std::numbers::pi;
  if (view.mode != ViewCamera::Mode::orbit) return turned(view, -0.5 * angle.x, -0.5 * angle.y);
  ViewCamera result = turned(view, -angle.x, -angle.y);
  result.eye = target_of(view) - result.distance * forward_of(result);
  return above_ground(result, terrain);
}

ViewCamera panned(const ViewCamera& view, const glm::dvec2& delta_px, double height_px,
                  double view_angle, const Terrain& terrain) {
  const double metres_a_px = 2.0 * view.distance * std::tan(0.5 * view_angle) / height_px;
  const glm::dvec3 right = right_of(view), up = glm::cross(right, forward_of(view));
  ViewCamera result = view;
  result.eye += metres_a_px * (delta_px.y * up - delta_px.x * right);
  return above_ground(result, terrain);
}

ViewCamera zoomed(const ViewCamera& view, double steps, const Terrain& terrain) {
  ViewCamera result = view;
  const double factor = std::pow(0.85, steps);
  if (view.mode != ViewCamera::Mode::orbit) {
    result.speed = std::clamp(view.speed / factor, 0.1, 1000.0);
    return result;
  }
  result.distance = std::clamp(view.distance * factor, kNearest, kFarthest);
  result.eye = target_of(view) - result.distance * forward_of(view);
  return above_ground(result, terrain);
}

ViewCamera walked_round(const ViewCamera& view, double angle, const Terrain& terrain) {
  ViewCamera result = turned(view, angle, 0.0);
  result.eye = target_of(view) - result.distance * forward_of(result);
  return above_ground(result, terrain);
}

bool is_moving(const Strides& strides) {
  return strides.forward != 0.0 || strides.right != 0.0 || strides.up != 0.0;
}

ViewCamera moved(const ViewCamera& view, const Strides& strides, double seconds,
                 const Terrain& terrain) {
  glm::dvec3 ahead = forward_of(view);
  double up = strides.up;
  if (view.mode != ViewCamera::Mode::fly) {
    ahead = {std::cos(view.heading), std::sin(view.heading), 0.0};
  }
  if (view.mode == ViewCamera::Mode::walk) up = 0.0;
  const double speed = view.mode == ViewCamera::Mode::orbit ? 0.5 * view.distance : view.speed;
  const double way = speed * (strides.fast ? 4.0 : 1.0) * seconds;
  ViewCamera result = view;
  result.eye += way * (strides.forward * ahead + strides.right * right_of(view) +
                       up * glm::dvec3(0.0, 0.0, 1.0));
  return above_ground(result, terrain);
}

ViewCamera switched(const ViewCamera& view, ViewCamera::Mode mode, const Terrain& terrain) {
  ViewCamera result = view;
  result.mode = mode;
  if (mode == ViewCamera::Mode::walk && view.mode != mode) result.pitch = 0.0;
  return above_ground(result, terrain);
}

Camera camera_of(const ViewCamera& view, const glm::ivec2& size_px, double view_angle) {
  Camera camera;
  camera.name = "view";
  camera.lens.width_px = size_px.x;
  camera.lens.height_px = size_px.y;
  camera.lens.focal_px = glm::dvec2(0.5 * size_px.y / std::tan(0.5 * view_angle));
  camera.lens.principal_px = 0.5 * glm::dvec2(size_px) - 0.5;
  const glm::dvec3 ahead = forward_of(view), right = right_of(view);
  camera.camera_from_world.rotation =
      glm::transpose(glm::dmat3(right, glm::cross(ahead, right), ahead));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * view.eye);
  return camera;
}

}  // namespace bosk
