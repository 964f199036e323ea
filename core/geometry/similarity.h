#pragma once

#include <glm/glm.hpp>
#include <span>

#include "core/geometry/rigid_transform.h"

namespace bosk {

// x_target = scale * rotation * x_source + translation; named target_from_source. What is left free
// when cameras are found from photos alone: position, orientation and size of the world.
struct Similarity {
  double scale = 1.0;
  glm::dmat3 rotation{1.0};
  glm::dvec3 translation{0.0};

  glm::dvec3 operator*(const glm::dvec3& point) const {
    return scale * (rotation * point) + translation;
  }
};

Similarity inverse(const Similarity& a_from_b);

// Least squares over the pairs: the smallest sum of |target - fit * source|^2. Throws Error for
// fewer than three pairs, points on one line, and coordinates that are not finite. The lists are
// equally long.
Similarity fit_similarity(std::span<const glm::dvec3> source, std::span<const glm::dvec3> target);

// The same camera in the moved and resized world: every point is seen at the same pixel, lengths in
// the camera's frame are `scale` times as long.
RigidTransform moved(const RigidTransform& camera_from_source,
                     const Similarity& target_from_source);

}  // namespace bosk
