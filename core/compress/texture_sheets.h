#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "core/billboard/billboard.h"
#include "core/compress/compress.h"
#include "core/image/image.h"

namespace bosk {

// Pictures of equal square tiles in rows, one clear pixel between them: tile i stands in column
// i % across and row i / across.
struct TileSheet {
  int tile_px = 4, across = 1, tiles = 0;
  Image<glm::u8vec4> picture;  // straight sRGB-encoded colour and alpha

  glm::ivec2 corner_px(int tile) const {
    return {(tile % across) * (tile_px + 1), (tile / across) * (tile_px + 1)};
  }
};

// The textures of one cell (its place in BillboardLevel::cells) towards every view, in the order of
// the level's views.
TileSheet cell_textures(const Billboards& billboards, std::size_t level, std::size_t cell,
                        int across = 4);
// The same as they come out of the codebooks. `atlas`: textures.atlas_rgba for exact ones, or
// atlas_from_bc3(textures) for them as GPUs see them.
TileSheet coded_cell_textures(const Billboards& billboards, const CodedTextures& textures,
                              const std::vector<glm::u8vec4>& atlas, std::size_t level,
                              std::size_t cell, int across = 4);
// Every texture of one view, cells in the order of the level (Morton order), from `first_cell` on.
TileSheet view_textures(const Billboards& billboards, std::size_t level, std::size_t view,
                        std::size_t first_cell, std::size_t cells, int across);

// The same as it comes out of the codebooks.
TileSheet coded_view_textures(const Billboards& billboards, const CodedTextures& textures,
                              const std::vector<glm::u8vec4>& atlas, std::size_t level,
                              std::size_t view, std::size_t first_cell, std::size_t cells,
                              int across);

// A level's codewords in their order: colours, opaque; alphas as white of that opacity.
TileSheet colour_codewords(const CodedTextures& textures, std::size_t level, int across = 32);
TileSheet alpha_codewords(const CodedTextures& textures, std::size_t level, int across = 32);

}  // namespace bosk
