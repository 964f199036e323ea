#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"

namespace bosk {

// Half the size, rounded up: each pixel is the mean of 2 x 2, fewer at an odd right or lower edge.
// For values whose mean means something: opacity, linear light, premultiplied linear light.
Image<float> half_size(const Image<float>& values);
Image<glm::vec3> half_size(const Image<glm::vec3>& linear);
Image<glm::vec4> half_size(const Image<glm::vec4>& premultiplied);

// The same for sRGB-encoded images: averaged in linear light, and weighted by alpha where there is
// one. Colour where the mean alpha is 0 is the plain mean, so that it stays finite.
Image<glm::vec3> half_size_srgb(const Image<glm::vec3>& srgb);
Image<glm::vec4> half_size_straight(const Image<glm::vec4>& straight_srgb);

// The image and its halves down to `smallest_px` along the longer side; [0] is the image itself.
std::vector<Image<glm::vec3>> pyramid_srgb(const Image<glm::vec3>& srgb, int smallest_px);

// Where a pixel of an image lies one level down and back; never p / 2.
inline glm::dvec2 half_size_pixel_from_pixel(const glm::dvec2& pixel) {
  return (pixel + 0.5) / 2.0 - 0.5;
}
inline glm::dvec2 pixel_from_half_size_pixel(const glm::dvec2& pixel) {
  return (pixel + 0.5) * 2.0 - 0.5;
}

}  // namespace bosk
