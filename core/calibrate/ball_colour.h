#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// Colour as balls are told apart by: `xy` is saturation, 100 (a*, b*) / (L* + 16), and z is L*. By
// CIELab's cube roots a surface of one colour has one saturation in sun and in shade. Below L* 24
// it is damped, since there it is mostly noise.
glm::vec3 saturation_from_lab(const glm::vec3& lab);
Image<glm::vec3> saturation_image(const Image<glm::vec3>& srgb);

// A photo as balls are looked for in it; all images have one size.
struct BallImage {
  Image<glm::vec3> saturation;
  Image<glm::vec3> linear;     // RGB
  Image<std::uint32_t> usage;  // pixels by their saturation: see common_pixels
};
BallImage ball_image(const Image<glm::vec3>& srgb);

// How many pixels of the photo have about this saturation (within 14 units or so).
double common_pixels(const BallImage& image, const glm::vec2& saturation);

// Bilinear between pixels, the nearest pixel outside.
glm::vec3 sample_bilinear(const Image<glm::vec3>& image, const glm::dvec2& pixel);

}  // namespace bosk
