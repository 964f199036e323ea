#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

// A camera at a place that looks at another, its picture upright.
inline Camera camera_looking(const std::string& name, const glm::dvec3& from,
                             const glm::dvec3& at) {
  Camera camera;
  camera.name = name;
  camera.lens.width_px = 400;
  camera.lens.height_px = 300;
  camera.lens.focal_px = glm::dvec2(500.0);
  camera.lens.principal_px = {199.5, 149.5};
  const glm::dvec3 ahead = glm::normalize(at - from);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 0, 1)));
  camera.camera_from_world.rotation =
      glm::transpose(glm::dmat3(right, glm::cross(ahead, right), ahead));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * from);
  return camera;
}

// On a circle around the point, at angles in degrees; named by those.
inline std::vector<Camera> cameras_at(const std::vector<double>& angles_deg,
                                      const glm::dvec3& middle = {1.0, 2.0, 3.0},
                                      double radius = 8.0, double above = -1.5) {
  std::vector<Camera> cameras;
  for (const double angle_deg : angles_deg) {
    const double angle = angle_deg * 0.017453292519943295;
    const glm::dvec3 offset(radius * std::cos(angle), radius * std::sin(angle), above);
    cameras.push_back(
        camera_looking(std::to_string(std::lround(angle_deg)), middle + offset, middle));
  }
  return cameras;
}

}  // namespace bosk
