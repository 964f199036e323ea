#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/matte/matte.h"
#include "core/photo/photo.h"

namespace bosk {

// A ball of constant extinction around (0, 0, 3), seen by pinhole cameras on a ring: every pixel's
// truth has a closed form. `split` colours the halves x > 0 and x < 0 differently.
struct BallScene {
  static constexpr int kSize = 64;           // of the photos, px
  static constexpr double kDistance = 5.0;   // of the cameras from the centre
  static constexpr double kFocalPx = 110.0;  // the ball is about 45 px across
  double radius = 1.0;
  double extinction = 40.0;  // per metre
  bool split = false;

  glm::dvec3 centre() const { return {0.0, 0.0, 3.0}; }
  // Straight colour and alpha along a ray from `eye`.
  glm::vec4 along(const glm::dvec3& eye, const glm::dvec3& unit_direction) const;
};

// A camera at `eye` that looks at `target`, +z up in the picture.
Camera camera_at(const glm::dvec3& eye, const glm::dvec3& target);
glm::dvec3 ring_place(const BallScene& scene, double turn, double height);

// Photos on the ring (alternately below and above the centre) and their mattes, the mean of 4x4
// rays a pixel.
Photos ring_photos(const BallScene& scene, int count);
Matte matte_of(const BallScene& scene, const Photo& photo);
Mattes mattes_of(const BallScene& scene, const Photos& photos);

}  // namespace bosk
