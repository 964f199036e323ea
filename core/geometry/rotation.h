#pragma once

#include <array>
#include <glm/glm.hpp>

namespace bosk {

// Rodrigues vector: the axis times the angle in radians, 0 to pi on the way out. As in OpenCV and
// mrcal.
glm::dmat3 rotation_from_rodrigues(const glm::dvec3& rodrigues);
glm::dvec3 rodrigues_from_rotation(const glm::dmat3& rotation);

struct RotationFit {
  glm::dmat3 rotation{1.0};
  // How well the data pin the rotation: 0 when turns about some axis fit as well (all points on a
  // line), of order 1 when they spread in two directions or more.
  double sharpness = 0.0;
};

// The rotation R that makes sum(target . R source) largest, given the sum of the outer products
// target source^T. Horn 1987, "Closed-form solution of absolute orientation using unit
// quaternions".
RotationFit fit_rotation(const glm::dmat3& target_by_source);

// The rotation nearest to a matrix that rounding has put slightly off (Frobenius norm).
glm::dmat3 nearest_rotation(const glm::dmat3& matrix);
// Largest absolute entry of M^T M - 1; for a mirror (determinant below zero) at least 1.
double rotation_error(const glm::dmat3& matrix);

}  // namespace bosk
