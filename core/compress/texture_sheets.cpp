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

// Puts texels in rows of `edge`, `texel` giving them by their place.
template <class Texel>
void put_square(const glm::ivec2& corner, int edge, const Texel& texel, TileSheet& sheet) {
  for (int i = 0; i < edge * edge; ++i) {
    sheet.picture(corner.x + i % edge, corner.y + i / edge) = texel(std::size_t(i));
  }
}

void put_texture(const BillboardLevel& level, std::size_t texture, int tile, TileSheet& sheet) {
  const std::size_t first = texture * level.texture_size();
  const auto texel = [&](std::size_t i) { return level.texture[first + i]; };
  put_square(sheet.corner_px(tile), level.texels, texel, sheet);
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
    const auto texel = [&](std::size_t k) { return texels[k]; };
    put_square(corner, kBlock, texel, sheet);
  }
}

// Calls put(texture, tile, sheet) for one cell's textures towards every view.
template <class Put>
TileSheet sheet_of_cell(const BillboardLevel& level, std::size_t cell, int across, const Put& put) {
  assert(cell < level.cells.size());
  const std::size_t views = level.views.size();
  TileSheet sheet = empty_sheet(level.texels, views, across);
  for (std::size_t view = 0; view < views; ++view) put(cell * views + view, int(view), sheet);
  return sheet;
}

// The same for one view's textures of the cells [first, first + cells), as far as there are any.
template <class Put>
TileSheet sheet_of_view(const BillboardLevel& level, std::size_t view, std::size_t first,
                        std::size_t cells, int across, const Put& put) {
  assert(view < level.views.size());
  const std::size_t end = std::min(first + cells, level.cells.size());
  TileSheet sheet = empty_sheet(level.texels, end - std::min(first, end), across);
  for (std::size_t cell = first; cell < end; ++cell) {
    put(cell * level.views.size() + view, int(cell - first), sheet);
  }
  return sheet;
}

auto putting(const BillboardLevel& level) {
  return [&level](std::size_t texture, int tile, TileSheet& sheet) {
    put_texture(level, texture, tile, sheet);
  };
}

auto putting_coded(const BillboardLevel& level, const CodedSource& coded) {
  return [&level, coded](std::size_t texture, int tile, TileSheet& sheet) {
    put_coded(level, coded, texture, tile, sheet);
  };
}

// Codewords from their tiles in the atlas, each texel's colour by `shown`.
template <class Shown>
TileSheet sheet_of_codewords(const CodedTextures& textures, std::uint32_t first_tile,
                             std::uint32_t count, int across, const Shown& shown) {
  TileSheet sheet = empty_sheet(kBlock, count, across);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto texel = [&](std::size_t k) {
      return shown(textures.atlas_rgba[atlas_texel(textures, first_tile + i, k)]);
    };
    put_square(sheet.corner_px(int(i)), kBlock, texel, sheet);
  }
  return sheet;
}

}  // namespace

TileSheet cell_textures(const Billboards& billboards, std::size_t level, std::size_t cell,
                        int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  return sheet_of_cell(source, cell, across, putting(source));
}

TileSheet coded_cell_textures(const Billboards& billboards, const CodedTextures& textures,
                              const std::vector<glm::u8vec4>& atlas, std::size_t level,
                              std::size_t cell, int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  return sheet_of_cell(source, cell, across, putting_coded(source, {textures, atlas, level}));
}

TileSheet view_textures(const Billboards& billboards, std::size_t level, std::size_t view,
                        std::size_t first_cell, std::size_t cells, int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  return sheet_of_view(source, view, first_cell, cells, across, putting(source));
}

TileSheet coded_view_textures(const Billboards& billboards, const CodedTextures& textures,
                              const std::vector<glm::u8vec4>& atlas, std::size_t level,
                              std::size_t view, std::size_t first_cell, std::size_t cells,
                              int across) {
  const BillboardLevel& source = billboards.levels.at(level);
  return sheet_of_view(source, view, first_cell, cells, across,
                       putting_coded(source, {textures, atlas, level}));
}

TileSheet colour_codewords(const CodedTextures& textures, std::size_t level, int across) {
  const CodedLevel& coded = textures.levels.at(level);
  return sheet_of_codewords(
      textures, coded.first_colour_tile, coded.colour_codewords, across,
      [](const glm::u8vec4& texel) { return glm::u8vec4(glm::u8vec3(texel), 255); });
}

TileSheet alpha_codewords(const CodedTextures& textures, std::size_t level, int across) {
  const CodedLevel& coded = textures.levels.at(level);
  return sheet_of_codewords(
      textures, coded.first_alpha_tile, coded.alpha_codewords, across,
      [](const glm::u8vec4& texel) { return glm::u8vec4(glm::u8vec3(255), texel.a); });
}

}  // namespace bosk
