#pragma once

#include <array>
#include <glm/glm.hpp>

namespace bosk {

// Real spherical harmonics up to degree 2, scaled so that coefficient 0 is the mean over all
// directions (1, sqrt(3) x, ...: orthonormal for the mean of the product over the sphere).
inline constexpr int kMaxCoefficients = 9;
inline std::array<float, kMaxCoefficients> harmonics(const glm::vec3& d) {
  constexpr float kRoot3 = 1.7320508f, kRoot15 = 3.8729833f, kRoot5 = 2.2360680f;
  return {1.0f,
          kRoot3 * d.x,
          kRoot3 * d.y,
          kRoot3 * d.z,
          kRoot15 * d.x * d.y,
          kRoot15 * d.y * d.z,
          kRoot15 * d.x * d.z,
          0.5f * kRoot15 * (d.x * d.x - d.y * d.y),
          0.5f * kRoot5 * (3.0f * d.z * d.z - 1.0f)};
}

}  // namespace bosk
