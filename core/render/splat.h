#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/render/code_texture.h"

namespace bosk {

// A billboard in the picture, a parallelogram: its texture's point (s, t), each -1 to 1 from edge
// to edge, rows downwards, falls on centre_px + s * across_px + t * down_px.
struct Splat {
  glm::vec2 centre_px{0.0f}, across_px{0.0f}, down_px{0.0f};
  std::uint32_t item = 0;  // position in the draw list
};

// Half the size of the splat's bounding box.
inline glm::vec2 half_extent_px(const Splat& splat) {
  return glm::abs(splat.across_px) + glm::abs(splat.down_px);
}

// A square part of the picture, premultiplied colour.
inline constexpr int kTile_px = 32;
struct Tile {
  int left_px = 0, top_px = 0;
  int width_px = 0, height_px = 0;  // at most kTile_px
  Float4 pixels[kTile_px * kTile_px];
};

// Draws the splat over what the tile holds, faded as DrawRange::fade says. `texture`: texels
// x texels, premultiplied, row by row; texels is 4 or 8. Each pixel gets the mean, over its own
// area, of the texture interpolated linearly between texel centres, held constant beyond the outer
// ones and transparent outside the square: so a splat of any size and place adds the same opacity
// in all as its texture holds. A turned splat is filtered along one axis after the other (two
// passes with shear, after Catmull and Smith 1980).
void composite_splat(const Splat& splat, const Float4* texture, int texels, float fade, Tile& tile);

}  // namespace bosk
