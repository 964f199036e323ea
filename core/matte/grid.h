#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// Coarse grids that are stretched over an image from edge to edge: what varies slowly is kept on
// them.
inline glm::ivec2 grid_size(int width, int height) {
  constexpr double kLongerSide = 256.0;
  const double scale = std::min(1.0, kLongerSide / std::max(width, height));
  return {std::max(1, int(std::lround(width * scale))),
          std::max(1, int(std::lround(height * scale)))};
}

// Where, between the centres of two cells of a row (or column) of cells, a pixel lies.
struct GridPlace {
  int first = 0, second = 0;
  float mix = 0.0f;
};

inline GridPlace place_in_cells(float cell, int cells) {
  const int first = std::clamp(int(std::floor(cell)), 0, cells - 1);
  return {first, std::min(first + 1, cells - 1), std::clamp(cell - float(first), 0.0f, 1.0f)};
}
inline GridPlace grid_place(int pixel, int pixels, int cells) {
  return place_in_cells((float(pixel) + 0.5f) * float(cells) / float(pixels) - 0.5f, cells);
}

// Bilinear sample of a grid.
struct GridPoint {
  GridPlace x, y;
  float sample(const Image<float>& grid) const {
    return std::lerp(std::lerp(grid(x.first, y.first), grid(x.second, y.first), x.mix),
                     std::lerp(grid(x.first, y.second), grid(x.second, y.second), x.mix), y.mix);
  }
};

}  // namespace bosk
