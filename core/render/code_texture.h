#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/package/tree_model.h"
#include "core/render/draw_list.h"

namespace bosk {

// Four floats that the compiler keeps in one vector register: red, green, blue, alpha.
using Float4 = float __attribute__((vector_size(16)));

// The atlas with the 16 texels of a tile side by side, straight sRGB-encoded colour and alpha.
struct TileTexels {
  std::vector<glm::u8vec4> texels;
  std::size_t tile_count() const { return texels.size() / 16; }
};

TileTexels exact_tiles(const CodeAtlas& atlas);
// What a GPU reads: every tile decoded from its BC3 block.
TileTexels gpu_tiles(const CodeAtlas& atlas);

inline constexpr int kMostTexels = 8;  // along a billboard's edge

// Writes the texture that an item shows, texels x texels, row by row: premultiplied colour of both
// views mixed by weight. Tiles outside the atlas count as pruned.
void decode_item(const TreeModel& model, const TileTexels& tiles, const DrawItem& item,
                 Float4* texture);

}  // namespace bosk
