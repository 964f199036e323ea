#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"
#include "core/render/code_texture.h"
#include "core/render/splat.h"

namespace bosk::toy {

// The texture at (u, v) in texels: linear between texel centres, held beyond the outer ones,
// nothing outside the square.
inline glm::dvec4 texture_at(const std::vector<Float4>& texture, int texels, double u, double v) {
  if (!(u >= 0.0 && u < texels && v >= 0.0 && v < texels)) return glm::dvec4(0.0);
  const double x = std::clamp(u - 0.5, 0.0, texels - 1.0),
               y = std::clamp(v - 0.5, 0.0, texels - 1.0);
  const int i = std::min(int(x), texels - 2), j = std::min(int(y), texels - 2);
  const auto texel = [&](int row, int column) {
    const Float4 t = texture[std::size_t(row * texels + column)];
    return glm::dvec4(t[0], t[1], t[2], t[3]);
  };
  return glm::mix(glm::mix(texel(j, i), texel(j, i + 1), x - i),
                  glm::mix(texel(j + 1, i), texel(j + 1, i + 1), x - i), y - j);
}

// Plain loops: the mean over a pixel's area of samples x samples point samples, composited over.
inline void slow_splat(const Splat& splat, const std::vector<Float4>& texture, int texels,
                       int samples, Image<glm::vec4>& image) {
  const glm::dmat2 pixel_from_square(glm::dvec2(splat.across_px), glm::dvec2(splat.down_px));
  const glm::dmat2 square_from_pixel = glm::inverse(pixel_from_square);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      glm::dvec4 sum(0.0);
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
          const glm::dvec2 at(x - 0.5 + (i + 0.5) / samples, y - 0.5 + (j + 0.5) / samples);
          const glm::dvec2 st = square_from_pixel * (at - glm::dvec2(splat.centre_px));
          sum +=
              texture_at(texture, texels, 0.5 * texels * (st.x + 1.0), 0.5 * texels * (st.y + 1.0));
        }
      const glm::vec4 mean(sum / double(samples * samples));
      image(x, y) = mean + (1.0f - mean.a) * image(x, y);
    }
}

}  // namespace bosk::toy
