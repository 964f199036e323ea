#pragma once

#include <glm/glm.hpp>

namespace bosk {

// CIEDE2000 (CIE 142-2001; Luo, Cui and Rigg 2001) with all weights 1. Lab as in
// core/image/colour.h.
double colour_difference_2000(const glm::dvec3& lab_a, const glm::dvec3& lab_b);

// The same between two sRGB-encoded colours, 0 to 1.
double colour_difference_srgb(const glm::dvec3& srgb_a, const glm::dvec3& srgb_b);

}  // namespace bosk
