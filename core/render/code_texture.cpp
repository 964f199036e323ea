#include "core/render/code_texture.h"

#include <squish.h>

#include <cstring>

#include "core/base/error.h"

namespace bosk {
namespace {

std::size_t tile_count(const CodeAtlas& atlas) {
  return std::size_t(atlas.width_px / 4) * std::size_t(atlas.height_px / 4);
}

Float4 to_float(const glm::u8vec4& texel) {
  return Float4{float(texel.r), float(texel.g), float(texel.b), float(texel.a)};
}

// Adds one 4x4 block to the texture, `stride` texels wide.
void add_block(const glm::u8vec4* colour, const glm::u8vec4* alpha, float weight, Float4* texture,
               int stride) {
  const float alpha_scale = weight / 255.0f;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const int texel = 4 * row + column;
      Float4 rgba = to_float(colour[texel]) * (1.0f / 255.0f);
      rgba[3] = 1.0f;
      texture[row * stride + column] += rgba * (float(alpha[texel].a) * alpha_scale);
    }
  }
}

void add_view(const TreeLevel& level, const TileTexels& tiles, std::uint32_t cell,
              std::uint32_t view, float weight, Float4* texture) {
  const int blocks = level.texels / 4;
  std::size_t at =
      (std::size_t(cell) * level.views.size() + view) * std::size_t(blocks) * std::size_t(blocks);
  for (int row = 0; row < blocks; ++row) {
    for (int column = 0; column < blocks; ++column, ++at) {
      if (level.alpha_indices[at] == kPruned) continue;
      const std::size_t alpha = std::size_t(level.alpha_codes.first) + level.alpha_indices[at];
      const std::size_t colour = std::size_t(level.colour_codes.first) + level.colour_indices[at];
      if (alpha >= tiles.tile_count() || colour >= tiles.tile_count()) continue;
      add_block(&tiles.texels[16 * colour], &tiles.texels[16 * alpha], weight,
                texture + std::ptrdiff_t(4) * (row * level.texels + column), level.texels);
    }
  }
}

}  // namespace

TileTexels exact_tiles(const CodeAtlas& atlas) {
  TileTexels tiles;
  tiles.texels.resize(16 * tile_count(atlas));
  const std::size_t width = std::size_t(atlas.width_px), across = width / 4;
  for (std::size_t tile = 0; tile < tile_count(atlas); ++tile)
    for (std::size_t row = 0; row < 4; ++row)
      std::memcpy(&tiles.texels[16 * tile + 4 * row],
                  &atlas.rgba[(4 * (tile / across) + row) * width + 4 * (tile % across)],
                  4 * sizeof(glm::u8vec4));
  return tiles;
}

TileTexels gpu_tiles(const CodeAtlas& atlas) {
  if (atlas.bc3.size() != 16 * tile_count(atlas))
    throw Error(
        "the tree has no complete BC3 atlas; render it from the exact one or pack it again");
  TileTexels tiles;
  tiles.texels.resize(16 * tile_count(atlas));
  for (std::size_t tile = 0; tile < tile_count(atlas); ++tile)
    squish::Decompress(&tiles.texels[16 * tile].r, &atlas.bc3[16 * tile], squish::kDxt5);
  return tiles;
}

void decode_item(const TreeModel& model, const TileTexels& tiles, const DrawItem& item,
                 Float4* texture) {
  const TreeLevel& level = model.levels[item.level_slot];
  for (int texel = 0; texel < level.texels * level.texels; ++texel) texture[texel] = Float4{};
  if (item.weight_b < 1.0f)
    add_view(level, tiles, item.cell, item.view_a, 1.0f - item.weight_b, texture);
  if (item.weight_b > 0.0f) add_view(level, tiles, item.cell, item.view_b, item.weight_b, texture);
}

}  // namespace bosk
