#include "core/compress/atlas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/compress/compress.h"
#include "leafy_billboards.h"

namespace bosk {
namespace {

BlockColours colours_of(std::uint8_t value) {
  BlockColours colours;
  colours.fill(glm::u8vec3(value));
  return colours;
}

BlockAlphas alphas_of(std::uint8_t value) {
  BlockAlphas alphas;
  alphas.fill(value);
  return alphas;
}

TEST(LayOutAtlas, SetsRangesOfLevelsOneAfterAnother) {
  CodedTextures textures;
  lay_out_atlas({{{colours_of(1), colours_of(2)}, {}}, {{colours_of(3)}, {}}},
                {{{alphas_of(10)}, {}}, {{alphas_of(20), alphas_of(30), alphas_of(40)}, {}}},
                textures);
  EXPECT_EQ(textures.levels[1].first_colour_tile, 2u);
  EXPECT_EQ(textures.levels[1].first_alpha_tile, 1u);
  EXPECT_EQ(textures.levels[1].alpha_codewords, 3u);
  ASSERT_EQ(textures.atlas_width_px, 8);  // 4 tiles, the most that either kind needs
  ASSERT_EQ(textures.atlas_height_px, 8);
  EXPECT_EQ(textures.atlas_rgba[atlas_texel(textures, 0, 0)], glm::u8vec4(1, 1, 1, 10));
  EXPECT_EQ(textures.atlas_rgba[atlas_texel(textures, 2, 7)], glm::u8vec4(3, 3, 3, 30));
  EXPECT_EQ(textures.atlas_rgba[atlas_texel(textures, 3, 15)], glm::u8vec4(0, 0, 0, 40));
}

TEST(LayOutAtlas, CountsTilesRowByRow) {
  CodedTextures textures;
  lay_out_atlas({{std::vector(16, colours_of(0)), {}}}, {{}}, textures);
  ASSERT_EQ(textures.atlas_width_px, 16);
  EXPECT_EQ(atlas_texel(textures, 5, 0), 4u * 16u + 4u);  // second row, second tile
  EXPECT_EQ(atlas_texel(textures, 5, 6), 5u * 16u + 6u);  // its second row, third texel
}

TEST(LayOutAtlas, RefusesMoreThanOnePage) {
  CodedTextures textures;
  std::vector<LevelColours> colours(5);
  for (auto& level : colours) level.codewords.assign(4000, colours_of(1));
  EXPECT_THROW(lay_out_atlas(colours, std::vector<LevelAlphas>(5), textures), Error);
  colours.resize(4);
  colours[0].codewords.resize(4384, colours_of(1));  // 16384 in all
  EXPECT_NO_THROW(lay_out_atlas(colours, std::vector<LevelAlphas>(4), textures));
  EXPECT_EQ(textures.atlas_width_px, 512);
  EXPECT_EQ(textures.atlas_height_px, 512);
}

struct Psnr {
  double colour_db, alpha_db;
};

Psnr bc3_psnr(const CodedTextures& textures) {
  const auto decoded = atlas_from_bc3(textures);
  double colour = 0.0, alpha = 0.0;
  for (std::size_t i = 0; i < decoded.size(); ++i) {
    const glm::dvec4 error = (glm::dvec4(decoded[i]) - glm::dvec4(textures.atlas_rgba[i])) / 255.0;
    colour += glm::dot(glm::dvec3(error), glm::dvec3(error)) / 3.0;
    alpha += error.a * error.a;
  }
  const double texels = double(decoded.size());
  return {-10.0 * std::log10(colour / texels), -10.0 * std::log10(alpha / texels)};
}

// Measured on these textures, which are noisier than a photo: 33.1 dB colour, 31.3 dB alpha. A
// fault of order, weighting or stride costs 10 dB and more.
TEST(Bc3FromAtlas, DecodesCloseToTheAtlas) {
  Progress quiet;
  const CodedTextures textures =
      compress_billboards(testing::leafy_billboards({.cells = 100}),
                          {.colour_codewords = 100, .alpha_codewords = 100}, quiet);
  ASSERT_EQ(textures.atlas_bc3.size(), textures.atlas_rgba.size());  // a byte a texel
  const Psnr psnr = bc3_psnr(textures);
  EXPECT_GT(psnr.colour_db, 32.0);
  EXPECT_GT(psnr.alpha_db, 30.0);
}

// Colour and alpha of a tile are strangers: a colour must not suffer where the alpha beside it is
// 0.
TEST(Bc3FromAtlas, FitsColourWithoutRegardToAlpha) {
  BlockColours ramp;
  for (std::size_t i = 0; i < 16; ++i) ramp[i] = glm::u8vec3(std::uint8_t(16 * i));
  BlockAlphas half{};
  std::fill(half.begin(), half.begin() + 8, std::uint8_t(255));
  const auto colours_beside = [&](const BlockAlphas& alphas) {
    CodedTextures textures;
    Progress quiet;
    lay_out_atlas({{{ramp}, {}}}, {{{alphas}, {}}}, textures);
    textures.atlas_bc3 = bc3_from_atlas(textures, quiet);
    std::vector<glm::u8vec3> colours;
    for (const auto& texel : atlas_from_bc3(textures)) colours.emplace_back(texel);
    return colours;
  };
  EXPECT_EQ(colours_beside(half), colours_beside(alphas_of(255)));
  EXPECT_EQ(colours_beside(alphas_of(0)), colours_beside(alphas_of(255)));
}

}  // namespace
}  // namespace bosk
