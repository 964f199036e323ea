#include "ui/workstation/calibrate/loupe.h"

#include <cmath>

namespace bosk {

Image<glm::u8vec4> loupe_of(const Image<glm::u8vec4>& picture, const glm::dvec2& at_px, int side) {
  Image<glm::u8vec4> loupe(side, side, glm::u8vec4(0));
  const glm::ivec2 first = glm::ivec2(glm::round(at_px)) - side / 2;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::ivec2 from = first + glm::ivec2(x, y);
      const bool inside =
          from.x >= 0 && from.y >= 0 && from.x < picture.width() && from.y < picture.height();
      if (inside) loupe(x, y) = picture(from.x, from.y);
    }
  }
  return loupe;
}

}  // namespace bosk
