#include "core/compress/texture_sheets.h"

#include <algorithm>
#include <cassert>

#include "core/compress/atlas.h"
#include "core/compress/rate_distortion.h"

namespace bosk {
namespace {

constexpr int kBlock = 4;  // texels along a block's edge

TileSheet empty_sheet(int tile_px, std::size_t tiles, int across) {
  assert(across > 0);
  TileSheet sheet{tile_px, std::min(across, std::max(1, int(tiles))), int(tiles), {}};
  const int rows = std::max(1, (sheet.tiles + sheet.across - 1) / sheet.across);
  sheet.picture = Image<glm::u8vec4>(sheet.across * (tile_px + 1) - 1, rows * (tile_px + 1) - 1);
  return sheet;
}

void put_texture(const BillboardLevel& level, std::size_t texture, int tile, TileSheet& sheet) {
  const glm::ivec2 corner = sheet.corner_px(tile);
  const std::size_t first = texture * level.texture_size();
  for (int i = 0; i < level.texels * level.texels; ++i) {
    sheet.picture(corner.x + i % level.texels, corner.y + i / level.texels) =
        level.texture[first + std::size_t(i)];
  }
}

template <class Texel>
void put_block(const glm::ivec2& corner, const Texel& texel, TileSheet& sheet) {
  for (int i = 0; i < kBlock * kBlock; ++i) {
    sheet.picture(corner.x + i % kBlock, corner.y + i / kBlock) = texel(std::size_t(i));
  }
}

// One level as its codebooks give it.
struct CodedSource {
  const CodedTextures& textures;
  const std::vector<glm::u8vec4>& atlas;
  std::size_t level = 0;
};

void put_coded(const BillboardLevel& level, const CodedSource& coded, std::size_t texture, int tile,
               TileSheet& sheet) {
  const int across = level.texels / kBlock, blocks = across * across;
  for (int i = 0; i < blocks; ++i) {
    const std::size_t block = texture * std::size_t(blocks) + std::size_t(i);
    const BlockTexels texels = decoded_block(coded.textures, coded.atlas, coded.level, block);
    const glm::ivec2 corner = sheet.corner_px(tile) + kBlock * glm::ivec2(i % across, i / across);
    put_block(
        corner, [&](std::size_t texel) { return texels[texel]; }, sheet);
  }
}

}  // namespace

TileSheet cell_textures(const Billboards& billboards, std::size_t level, std::size_t cell,
                        int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  const std::size_t views = source.views.size();
  assert(cell < source.cells.size());
  TileSheet sheet = empty_sheet(source.texels, views, across);
  for (std::size_t view = 0; view < views; ++view) {
    put_texture(source, cell * views + view, int(view), sheet);
  }
  return sheet;
}

TileSheet coded_cell_textures(const Billboards& billboards, const CodedTextures& textures,
                              const std::vector<glm::u8vec4>& atlas, std::size_t level,
                              std::size_t cell, int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  const std::size_t views = source.views.size();
  assert(cell < source.cells.size());
  TileSheet sheet = empty_sheet(source.texels, views, across);
  for (std::size_t view = 0; view < views; ++view) {
    put_coded(source, {textures, atlas, level}, cell * views + view, int(view), sheet);
  }
  return sheet;
}

TileSheet view_textures(const Billboards& billboards, std::size_t level, std::size_t view,
                        std::size_t first_cell, std::size_t cells, int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  assert(view < source.views.size());
  const std::size_t end = std::min(first_cell + cells, source.cells.size());
  TileSheet sheet = empty_sheet(source.texels, end - std::min(first_cell, end), across);
  for (std::size_t cell = first_cell; cell < end; ++cell) {
    put_texture(source, cell * source.views.size() + view, int(cell - first_cell), sheet);
  }
  return sheet;
}

TileSheet coded_view_textures(const Billboards& billboards, const CodedTextures& textures,
                              const std::vector<glm::u8vec4>& atlas, std::size_t level,
                              std::size_t view, std::size_t first_cell, std::size_t cells,
                              int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  assert(view < source.views.size());
  const std::size_t end = std::min(first_cell + cells, source.cells.size());
  TileSheet sheet = empty_sheet(source.texels, end - std::min(first_cell, end), across);
  for (std::size_t cell = first_cell; cell < end; ++cell) {
    put_coded(source, {textures, atlas, level}, cell * source.views.size() + view,
              int(cell - first_cell), sheet);
  }
  return sheet;
}

TileSheet colour_codewords(const CodedTextures& textures, std::size_t level, int across) {
  const CodedLevel& coded = textures.levels.at(level);
  TileSheet sheet = empty_sheet(kBlock, coded.colour_codewords, across);
  for (std::uint32_t i = 0; i < coded.colour_codewords; ++i) {
    put_block(
        sheet.corner_px(int(i)),
        [&](std::size_t texel) {
          const std::size_t place = atlas_texel(textures, coded.first_colour_tile + i, texel);
          return glm::u8vec4(glm::u8vec3(textures.atlas_rgba[place]), 255);
        },
        sheet);
  }
  return sheet;
}

TileSheet alpha_codewords(const CodedTextures& textures, std::size_t level, int across) {
  const CodedLevel& coded = textures.levels.at(level);
  TileSheet sheet = empty_sheet(kBlock, coded.alpha_codewords, across);
  for (std::uint32_t i = 0; i < coded.alpha_codewords; ++i) {
    put_block(
        sheet.corner_px(int(i)),
        [&](std::size_t texel) {
          const std::size_t place = atlas_texel(textures, coded.first_alpha_tile + i, texel);
          return glm::u8vec4(glm::u8vec3(255), textures.atlas_rgba[place].a);
        },
        sheet);
  }
  return sheet;
}

}  // namespace bosk
