#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace bosk {

// The cone that is drawn: of a half opening around a direction, its tip at the eye.
class ViewCone {
 public:
  explicit ViewCone(double half_angle)
      : cosine_(std::cos(half_angle)), sine_(std::sin(half_angle)) {}

  // Distance of a point from the cone's surface, negative inside: a ball of that radius touches it.
  // `forward` has unit length.
  double beyond(const glm::dvec3& from_eye, const glm::dvec3& forward) const {
    const double depth = glm::dot(from_eye, forward);
    const double across = std::sqrt(std::max(0.0, glm::dot(from_eye, from_eye) - depth * depth));
    return across * cosine_ - depth * sine_;
  }

 private:
  double cosine_, sine_;
};

}  // namespace bosk
