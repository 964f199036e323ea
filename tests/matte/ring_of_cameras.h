#pragma once

#include <cmath>

#include "core/photo/photo.h"

namespace bosk {

// Looks from 10 m at the origin, camera axes x right, y down, z forward, world z up.
inline Camera camera_around(double angle, int width_px, int height_px, double focal_px) {
  Camera camera;
  camera.lens = {LensModel::pinhole,
                 width_px,
                 height_px,
                 glm::dvec2(focal_px),
                 0.5 * glm::dvec2(width_px - 1, height_px - 1),
                 {}};
  const glm::dvec3 forward(-std::cos(angle), -std::sin(angle), 0.0), down(0.0, 0.0, -1.0);
  const glm::dvec3 right = glm::cross(down, forward);
  camera.camera_from_world.rotation = glm::transpose(glm::dmat3(right, down, forward));
  camera.camera_from_world.translation = {0.0, 0.0, 10.0};
  return camera;
}

}  // namespace bosk
