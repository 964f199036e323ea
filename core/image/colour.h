#pragma once

#include <glm/glm.hpp>

namespace bosk {

// The sRGB curve (IEC 61966-2-1) and CIE 1976 L*a*b* for D65, in floating point: 8-bit Lab rounds by up
// to 2 units. Encoded and linear values run from 0 to 1; values outside pass through the same formulas,
// negative ones mirrored, so that round trips hold.
float linear_from_srgb(float encoded);
float srgb_from_linear(float linear);
glm::vec3 linear_from_srgb(const glm::vec3& encoded);
glm::vec3 srgb_from_linear(const glm::vec3& linear);

// L* 0 to 100, a* and b* about -128 to 127.
glm::vec3 lab_from_linear(const glm::vec3& linear_rgb);
glm::vec3 linear_from_lab(const glm::vec3& lab);
inline glm::vec3 lab_from_srgb(const glm::vec3& encoded) {
  return lab_from_linear(linear_from_srgb(encoded));
}
inline glm::vec3 srgb_from_lab(const glm::vec3& lab) { return srgb_from_linear(linear_from_lab(lab)); }

}  // namespace bosk
