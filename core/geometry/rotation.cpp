#include "core/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace bosk {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

struct Eigen4 {
  dvec4 values{0.0};
  dmat4 vectors{1.0};  // one a column
};

// One Jacobi rotation that zeroes entry (p, q) of the symmetric matrix.
void jacobi_rotate(dmat4& matrix, dmat4& vectors, int p, int q) {
  if (matrix[p][q] == 0.0) return;
  const double theta = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double cosine = 1.0 / std::hypot(t, 1.0), sine = t * cosine;
  dmat4 turn(1.0);
  turn[p][p] = turn[q][q] = cosine;
  turn[q][p] = sine;
  turn[p][q] = -sine;
  matrix = glm::transpose(turn) * matrix * turn;
  vectors = vectors * turn;
}

// Cyclic Jacobi; a symmetric 4 x 4 matrix is diagonal to rounding after a few sweeps.
Eigen4 eigen_symmetric(dmat4 matrix) {
  Eigen4 result;
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int p = 0; p < 3; ++p)
      for (int q = p + 1; q < 4; ++q) jacobi_rotate(matrix, result.vectors, p, q);
  for (int i = 0; i < 4; ++i) result.values[i] = matrix[i][i];
  return result;
}

// Horn's matrix: its quadratic form in the quaternion (w, x, y, z) is sum(target . R source).
// s(a, b) = sum of source_a target_b.
dmat4 horn_matrix(const dmat3& target_by_source) {
  const auto s = [&](int a, int b) { return target_by_source[a][b]; };
  const double w_x = s(1, 2) - s(2, 1), w_y = s(2, 0) - s(0, 2), w_z = s(0, 1) - s(1, 0);
  const double x_y = s(0, 1) + s(1, 0), z_x = s(2, 0) + s(0, 2), y_z = s(1, 2) + s(2, 1);
  return dmat4(s(0, 0) + s(1, 1) + s(2, 2), w_x, w_y, w_z,   //
               w_x, s(0, 0) - s(1, 1) - s(2, 2), x_y, z_x,   //
               w_y, x_y, -s(0, 0) + s(1, 1) - s(2, 2), y_z,  //
               w_z, z_x, y_z, -s(0, 0) - s(1, 1) + s(2, 2));
}

}  // namespace

dmat3 rotation_from_rodrigues(const dvec3& rodrigues) {
  const double angle = glm::length(rodrigues);
  const double half_sine = angle < 1e-8 ? 0.5 : std::sin(0.5 * angle) / angle;
  return glm::mat3_cast(glm::normalize(glm::dquat(std::cos(0.5 * angle), half_sine * rodrigues)));
}

dvec3 rodrigues_from_rotation(const dmat3& rotation) {
  glm::dquat q = glm::normalize(glm::quat_cast(rotation));
  if (q.w < 0.0) q = -q;
  const dvec3 axis(q.x, q.y, q.z);
  const double sine = glm::length(axis);
  return sine < 1e-12 ? 2.0 * axis : 2.0 * std::atan2(sine, q.w) / sine * axis;
}

RotationFit fit_rotation(const dmat3& target_by_source) {
  const Eigen4 eigen = eigen_symmetric(horn_matrix(target_by_source));
  int best = 0;
  for (int i = 1; i < 4; ++i)
    if (eigen.values[i] > eigen.values[best]) best = i;
  double second = -std::abs(eigen.values[best]);
  for (int i = 0; i < 4; ++i)
    if (i != best) second = std::max(second, eigen.values[i]);
  const dvec4 q = eigen.vectors[best];
  const double largest = eigen.values[best];
  return {glm::mat3_cast(glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]))),
          largest > 0.0 ? (largest - second) / largest : 0.0};
}

dmat3 nearest_rotation(const dmat3& matrix) { return fit_rotation(matrix).rotation; }

double rotation_error(const dmat3& matrix) {
  const dmat3 excess = glm::transpose(matrix) * matrix - dmat3(1.0);
  double largest = glm::determinant(matrix) > 0.0 ? 0.0 : 1.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(excess[column][row]));
  return largest;
}

}  // namespace bosk
