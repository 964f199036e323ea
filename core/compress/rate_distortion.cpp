#include "core/compress/rate_distortion.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/compress/atlas.h"
#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr std::size_t kChunk = 1024;  // blocks summed together, whatever the thread count

struct ErrorSums {
  double colour_weight = 0, colour_square = 0, block_colour_square = 0, delta_e = 0, lightness = 0;
  double texels = 0, alpha_square = 0, block_alpha_square = 0, alpha = 0;

  void add(const ErrorSums& other) {
    colour_weight += other.colour_weight;
    colour_square += other.colour_square;
    block_colour_square += other.block_colour_square;
    delta_e += other.delta_e;
    lightness += other.lightness;
    texels += other.texels;
    alpha_square += other.alpha_square;
    block_alpha_square += other.block_alpha_square;
    alpha += other.alpha;
  }
};

// Colour errors count by alpha: sums of weight and of weight * error, for the block's mean.
struct ColourError {
  double weight = 0;
  glm::dvec3 sum{0.0};
};

void add_colour(const glm::u8vec4& truth, const glm::u8vec4& decoded, ErrorSums& sums,
                ColourError& block) {
  const glm::vec3 a = glm::vec3(truth) / 255.0f, b = glm::vec3(decoded) / 255.0f;
  const double weight = double(truth.a) / 255.0;
  const glm::vec3 lab_difference = lab_from_srgb(b) - lab_from_srgb(a);
  sums.colour_weight += weight;
  sums.colour_square += weight * double(glm::dot(b - a, b - a)) / 3.0;
  sums.delta_e += weight * double(glm::length(lab_difference));
  sums.lightness += weight * double(lab_difference.x);
  block.weight += weight;
  block.sum += weight * glm::dvec3(b - a);
}

void add_block(const BlockTexels& truth, const BlockTexels& decoded, ErrorSums& sums) {
  ColourError colour;
  double alpha = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double error = (double(decoded[i].a) - double(truth[i].a)) / 255.0;
    alpha += error;
    sums.alpha_square += error * error;
    if (truth[i].a > 0) add_colour(truth[i], decoded[i], sums, colour);
  }
  sums.texels += 16.0;
  sums.alpha += alpha;
  sums.block_alpha_square += alpha * alpha / 16.0;
  sums.block_colour_square += glm::dot(colour.sum, colour.sum) / (3.0 * colour.weight);
}

double psnr_db(double square, double count) {
  if (square <= 0.0 || count <= 0.0) return std::numeric_limits<double>::infinity();
  return -10.0 * std::log10(square / count);
}

double entropy_bits(const std::vector<std::uint16_t>& symbols) {
  std::vector<double> counts(65536);
  for (const std::uint16_t symbol : symbols) counts[symbol] += 1.0;
  double bits = 0.0;
  for (const double count : counts) {
    const double share = count / double(symbols.size());
    if (count > 0.0) bits -= share * std::log2(share);
  }
  return bits;
}

std::vector<std::uint16_t> visible_colours(const CodedLevel& level) {
  std::vector<std::uint16_t> indices;
  for (std::size_t i = 0; i < level.alpha_indices.size(); ++i) {
    if (level.alpha_indices[i] != kPrunedIndex) indices.push_back(level.colour_indices[i]);
  }
  return indices;
}

ErrorSums level_errors(const BillboardLevel& truth, const CodedTextures& textures,
                       const std::vector<glm::u8vec4>& atlas, std::size_t level,
                       Progress& progress) {
  const std::size_t blocks = block_count(truth);
  std::vector<ErrorSums> chunks((blocks + kChunk - 1) / kChunk);
  tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t chunk) {
    const std::size_t end = std::min(blocks, (chunk + 1) * kChunk);
    for (std::size_t block = chunk * kChunk; block < end; ++block) {
      if (textures.levels[level].alpha_indices[block] == kPrunedIndex) continue;
      add_block(block_texels(truth, block), decoded_block(textures, atlas, level, block),
                chunks[chunk]);
    }
    progress.advance();
  });
  ErrorSums sums;
  for (const ErrorSums& chunk : chunks) sums.add(chunk);
  return sums;
}

LevelRateDistortion summary(const ErrorSums& sums, const CodedLevel& coded) {
  LevelRateDistortion result;
  result.colour_psnr_db = psnr_db(sums.colour_square, sums.colour_weight);
  result.alpha_psnr_db = psnr_db(sums.alpha_square, sums.texels);
  result.block_colour_psnr_db = psnr_db(sums.block_colour_square, sums.colour_weight);
  result.block_alpha_psnr_db = psnr_db(sums.block_alpha_square, sums.texels);
  result.colour_delta_e = sums.delta_e / std::max(sums.colour_weight, 1e-9);
  result.lightness_bias = sums.lightness / std::max(sums.colour_weight, 1e-9);
  result.alpha_bias = sums.alpha / std::max(sums.texels, 1.0);
  const auto colours = visible_colours(coded);
  result.blocks = coded.alpha_indices.size();
  result.pruned = result.blocks - colours.size();
  result.colour_entropy_bits = colours.empty() ? 0.0 : entropy_bits(colours);
  result.alpha_entropy_bits = result.blocks == 0 ? 0.0 : entropy_bits(coded.alpha_indices);
  const double bits = result.colour_entropy_bits * double(colours.size()) +
                      result.alpha_entropy_bits * double(result.blocks);
  result.raw_bytes = result.blocks * 64;
  result.index_bytes = std::size_t(std::ceil(bits / 8.0));
  result.codeword_bytes = std::size_t(8) * (coded.colour_codewords + coded.alpha_codewords);
  return result;
}

}  // namespace

BlockTexels decoded_block(const CodedTextures& textures, const std::vector<glm::u8vec4>& atlas,
                          std::size_t level, std::size_t block) {
  const CodedLevel& coded = textures.levels[level];
  BlockTexels texels{};
  const std::uint16_t alpha = coded.alpha_indices[block];
  if (alpha == kPrunedIndex) return texels;
  const std::size_t colour_tile = coded.first_colour_tile + coded.colour_indices[block];
  const std::size_t alpha_tile = coded.first_alpha_tile + alpha;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    texels[i] = glm::u8vec4(glm::u8vec3(atlas[atlas_texel(textures, colour_tile, i)]),
                            atlas[atlas_texel(textures, alpha_tile, i)].a);
  }
  return texels;
}

std::vector<LevelRateDistortion> rate_distortion(const Billboards& billboards,
                                                 const CodedTextures& textures, bool from_bc3,
                                                 Progress& progress) {
  const auto atlas = from_bc3 ? atlas_from_bc3(textures) : textures.atlas_rgba;
  std::size_t chunks = 0;
  for (const BillboardLevel& level : billboards.levels) chunks += block_count(level) / kChunk + 1;
  progress.begin("Measuring the compression", chunks);
  std::vector<LevelRateDistortion> results;
  for (std::size_t level = 0; level < billboards.levels.size(); ++level) {
    const ErrorSums sums = level_errors(billboards.levels[level], textures, atlas, level, progress);
    results.push_back(summary(sums, textures.levels[level]));
    results.back().level = billboards.levels[level].level;
  }
  return results;
}

OverallPsnr overall_psnr(std::span<const LevelRateDistortion> levels) {
  double colour = 0.0, alpha = 0.0, blocks = 0.0;
  for (const LevelRateDistortion& level : levels) {
    const auto shown = double(level.blocks - level.pruned);
    colour += shown * std::pow(10.0, -0.1 * level.colour_psnr_db);
    alpha += shown * std::pow(10.0, -0.1 * level.alpha_psnr_db);
    blocks += shown;
  }
  return {psnr_db(colour, blocks), psnr_db(alpha, blocks)};
}

}  // namespace bosk
