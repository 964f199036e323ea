#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/compress/compress.h"
#include "core/compress/level_codes.h"

namespace bosk {

// Tiles one codeword wide and high, row by row; rgb and a of a tile are unrelated.
//   tile t = texels [4 (t % across), 4 (t / across)] .. + 3, across = width / 4, at most 128
//   rgb:  | colours of level 0 | colours of level 1 | ... |
//   a:    | alphas of level 0 | alphas of level 1 | ...       |
inline constexpr std::size_t kMostTiles = std::size_t(128) * 128;

// Where texel `i` (0 to 15, row by row) of a tile stands in the row-major picture.
std::size_t atlas_texel(const CodedTextures& textures, std::size_t tile, std::size_t i);

// Lays out the codewords and says where each level's are; fills all of `textures` but the indices.
// Throws Error when they don't fit into 512 x 512 texels.
void lay_out_atlas(const std::vector<LevelColours>& colours, const std::vector<LevelAlphas>& alphas,
                   CodedTextures& textures);

// One 16-byte BC3 block a tile, in the order of the tiles. Colour is fitted without regard to
// alpha.
std::vector<std::uint8_t> bc3_from_atlas(const CodedTextures& textures, Progress& progress);

// What a GPU makes of the BC3 blocks, laid out as CodedTextures::atlas_rgba.
std::vector<glm::u8vec4> atlas_from_bc3(const CodedTextures& textures);

}  // namespace bosk
