#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

// How codewords become bytes: texels tile by tile, a plane each of green, red - green, blue - green
// and alpha; each value less what its left and upper neighbour in the tile lead to expect, modulo
// 256.
namespace bosk {

// Texel `t` (0 to 15, row by row) of `tile`, as an index into CodeAtlas::rgba.
inline std::size_t atlas_index(const CodeAtlas& atlas, std::size_t tile, std::size_t t) {
  const auto width = std::size_t(atlas.width_px), across = width / 4;
  return (tile / across * 4 + t / 4) * width + tile % across * 4 + t % 4;
}

// One walk for both directions; `texels` in tile order. code(expected, value) returns the value: an
// encoder gets it, a decoder ignores what it gets.
template <class Code>
void walk_plane(std::span<glm::u8vec4> texels, int channel, Code&& code) {
  constexpr int kGreen = 1, kAlpha = 3;
  const bool differs_from_green = channel != kGreen && channel != kAlpha;
  const auto base = [&](const glm::u8vec4& texel) {
    return differs_from_green ? int(texel[kGreen]) : 0;
  };
  const auto beyond_base = [&](std::size_t i) { return int(texels[i][channel]) - base(texels[i]); };
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const std::size_t row = i % 16 / 4, column = i % 4;
    int expected = 0;
    if (channel == kAlpha) {
      expected = 0;  // codewords of opacity are too ragged for their neighbours to tell
    } else if (row > 0 && column > 0) {
      expected = (beyond_base(i - 1) + beyond_base(i - 4)) >> 1;
    } else if (row > 0 || column > 0) {
      expected = beyond_base(row > 0 ? i - 4 : i - 1);
    } else if (i > 0) {
      expected = beyond_base(i - 16);
    }
    expected += base(texels[i]);
    texels[i][channel] = code(std::uint8_t(expected & 0xff), texels[i][channel]);
  }
}

// Green first: red and blue build on it.
template <class Code>
void walk_atlas(std::span<glm::u8vec4> texels, Code&& code) {
  for (const int channel : {1, 0, 2, 3}) walk_plane(texels, channel, code);
}

}  // namespace bosk
