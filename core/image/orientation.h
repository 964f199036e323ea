#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// How pixels as delivered stand when they are shown upright. `orientation` is EXIF's, 1 to 8;
// anything else counts as 1. `size` is that of the image as delivered, in pixels.
glm::ivec2 upright_size(const glm::ivec2& size, int orientation);

// Where a pixel as delivered is shown, and back. (0, 0) is the centre of the first pixel in both.
glm::dvec2 upright_from_pixel(const glm::dvec2& pixel, const glm::ivec2& size, int orientation);
glm::dvec2 pixel_from_upright(const glm::dvec2& upright, const glm::ivec2& size, int orientation);

// Texture coordinates of the image as delivered at the corners of the upright picture, clockwise
// from its top left; 0 to 1.
std::array<glm::vec2, 4> corner_textures(int orientation);

template <class T>
Image<T> upright(const Image<T>& image, int orientation) {
  const glm::ivec2 size(image.width(), image.height());
  const glm::ivec2 shown = upright_size(size, orientation);
  Image<T> result(shown.x, shown.y);
  for (int y = 0; y < shown.y; ++y) {
    for (int x = 0; x < shown.x; ++x) {
      const glm::ivec2 pixel(pixel_from_upright({x, y}, size, orientation));
      result(x, y) = image(pixel.x, pixel.y);
    }
  }
  return result;
}

}  // namespace bosk
