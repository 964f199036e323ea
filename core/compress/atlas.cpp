#include "core/compress/atlas.h"

#include <squish.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr int kFlags = squish::kDxt5 | squish::kColourClusterFit;
constexpr std::size_t kBlockBytes = 16;

std::size_t tiles_across(const CodedTextures& textures) {
  return std::size_t(textures.atlas_width_px) / 4;
}

std::size_t tile_count(const CodedTextures& textures) {
  return tiles_across(textures) * std::size_t(textures.atlas_height_px) / 4;
}

// About square, at least one tile.
void set_size(std::size_t tiles, CodedTextures& textures) {
  if (tiles > kMostTiles) {
    throw Error("the codewords of all levels take " + std::to_string(tiles) +
                " tiles, but the atlas holds " + std::to_string(kMostTiles) +
                "; use fewer codewords or fewer levels");
  }
  std::size_t across = 1;
  while (across * across < tiles) across *= 2;
  const std::size_t rows = std::max<std::size_t>(1, (tiles + across - 1) / across);
  textures.atlas_width_px = int(4 * across);
  textures.atlas_height_px = int(4 * rows);
  textures.atlas_rgba.assign(16 * across * rows, glm::u8vec4(0));
}

void set_ranges(const std::vector<LevelColours>& colours, const std::vector<LevelAlphas>& alphas,
                CodedTextures& textures) {
  std::size_t next_colour = 0, next_alpha = 0;
  for (std::size_t level = 0; level < colours.size(); ++level) {
    CodedLevel& coded = textures.levels[level];
    coded.first_colour_tile = std::uint32_t(next_colour);
    coded.colour_codewords = std::uint32_t(colours[level].codewords.size());
    coded.first_alpha_tile = std::uint32_t(next_alpha);
    coded.alpha_codewords = std::uint32_t(alphas[level].codewords.size());
    next_colour += coded.colour_codewords;
    next_alpha += coded.alpha_codewords;
  }
  set_size(std::max(next_colour, next_alpha), textures);
}

std::array<glm::u8vec4, 16> tile_texels(const CodedTextures& textures, std::size_t tile) {
  std::array<glm::u8vec4, 16> texels;
  for (std::size_t i = 0; i < 16; ++i) {
    texels[i] = textures.atlas_rgba[atlas_texel(textures, tile, i)];
  }
  return texels;
}

}  // namespace

std::size_t atlas_texel(const CodedTextures& textures, std::size_t tile, std::size_t i) {
  const std::size_t across = tiles_across(textures);
  const std::size_t x = 4 * (tile % across) + i % 4;
  const std::size_t y = 4 * (tile / across) + i / 4;
  return y * std::size_t(textures.atlas_width_px) + x;
}

void lay_out_atlas(const std::vector<LevelColours>& colours, const std::vector<LevelAlphas>& alphas,
                   CodedTextures& textures) {
  textures.levels.resize(colours.size());
  set_ranges(colours, alphas, textures);
  std::size_t tile = 0;
  for (const LevelColours& level : colours) {
    for (const BlockColours& codeword : level.codewords) {
      for (std::size_t i = 0; i < 16; ++i) {
        glm::u8vec4& texel = textures.atlas_rgba[atlas_texel(textures, tile, i)];
        texel = glm::u8vec4(codeword[i], texel.a);
      }
      ++tile;
    }
  }
  tile = 0;
  for (const LevelAlphas& level : alphas) {
    for (const BlockAlphas& codeword : level.codewords) {
      for (std::size_t i = 0; i < 16; ++i) {
        textures.atlas_rgba[atlas_texel(textures, tile, i)].a = codeword[i];
      }
      ++tile;
    }
  }
}

std::vector<std::uint8_t> bc3_from_atlas(const CodedTextures& textures, Progress& progress) {
  std::vector<std::uint8_t> bc3(tile_count(textures) * kBlockBytes);
  tbb::parallel_for(std::size_t(0), tile_count(textures), [&](std::size_t tile) {
    const auto texels = tile_texels(textures, tile);
    std::array<squish::u8, 64> bytes;
    std::memcpy(bytes.data(), texels.data(), bytes.size());
    squish::Compress(bytes.data(), bc3.data() + tile * kBlockBytes, kFlags);
    progress.advance();
  });
  return bc3;
}

std::vector<glm::u8vec4> atlas_from_bc3(const CodedTextures& textures) {
  std::vector<glm::u8vec4> rgba(textures.atlas_rgba.size());
  for (std::size_t tile = 0; tile < tile_count(textures); ++tile) {
    std::array<squish::u8, 64> bytes;
    squish::Decompress(bytes.data(), textures.atlas_bc3.data() + tile * kBlockBytes, kFlags);
    for (std::size_t i = 0; i < 16; ++i) {
      std::memcpy(&rgba[atlas_texel(textures, tile, i)], &bytes[4 * i], 4);
    }
  }
  return rgba;
}

}  // namespace bosk
