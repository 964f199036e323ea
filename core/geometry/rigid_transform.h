#pragma once

#include <glm/glm.hpp>

namespace bosk {

// x_target = rotation * x_source + translation; named target_from_source.
// glm matrices are column-major: rotation[c][r]. rotation is orthonormal, determinant +1.
struct RigidTransform {
  glm::dmat3 rotation{1.0};
  glm::dvec3 translation{0.0};

  glm::dvec3 operator*(const glm::dvec3& point) const { return rotation * point + translation; }
};

inline RigidTransform operator*(const RigidTransform& a_from_b, const RigidTransform& b_from_c) {
  return {a_from_b.rotation * b_from_c.rotation, a_from_b * b_from_c.translation};
}

inline RigidTransform inverse(const RigidTransform& a_from_b) {
  const glm::dmat3 turned = glm::transpose(a_from_b.rotation);
  return {turned, -(turned * a_from_b.translation)};
}

}  // namespace bosk
