#include "core/compress/level_codes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/compress/cluster_statistics.h"
#include "core/compress/code_kinds.h"

namespace bosk {
namespace {

// Share that a clear texel counts with, next to 1 for an opaque one: enough to settle its colour.
constexpr float kClearWeight = 1.0f / 32.0f;

ColourSpace colour_space(const CompressOptions& options) {
  if (options.colour_space == "lab") return ColourSpace::lab;
  return options.colour_space == "srgb" ? ColourSpace::srgb : ColourSpace::lab_log_chroma;
}

// Reads the kinds of one level's colour blocks.
struct ColourKinds {
  const BillboardLevel& level;
  const DistinctBlocks& blocks;
  ColourSpace space;
  float mean_weight;
  bool constant;  // every kind has one colour: three coordinates say all

  ColourBlock operator[](std::uint32_t kind) const {
    return colour_block(block_texels(level, blocks.first_block[kind]));
  }
};

float texel_weight(std::uint8_t alpha) { return std::max(float(alpha) / 255.0f, kClearWeight); }

// Adds the block's mean as one more texel that weighs `mean_weight` times as much as all 16.
void append_mean(std::span<const float, 48> coordinates, const std::array<float, 16>& texel_weights,
                 float mean_weight, VectorSet& vectors) {
  std::array<float, 3> sum{};
  float total = 0.0f;
  for (std::size_t i = 0; i < 16; ++i) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += texel_weights[i] * coordinates[3 * i + c];
    total += texel_weights[i];
  }
  for (const float channel : sum) vectors.values.push_back(channel / total);
  vectors.weights.push_back(total * mean_weight);
}

VectorSet colour_vectors(const ColourKinds& colours, std::span<const std::uint32_t> kinds,
                         std::span<const float> weights) {
  VectorSet vectors{colours.constant ? 1u : 17u, 3, {}, {}};
  vectors.values.reserve(kinds.size() * vectors.dimension());
  vectors.weights.reserve(kinds.size() * vectors.groups);
  std::array<float, 48> coordinates;
  std::array<float, 16> texel_weights;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const ColourBlock block = colours[kinds[i]];
    write_coordinates(block.srgb, colours.space, coordinates);
    std::transform(block.alpha.begin(), block.alpha.end(), texel_weights.begin(),
                   [&](std::uint8_t alpha) { return weights[i] * texel_weight(alpha); });
    const auto texels = std::ptrdiff_t(colours.constant ? 1 : 16);
    vectors.values.insert(vectors.values.end(), coordinates.begin(),
                          coordinates.begin() + 3 * texels);
    vectors.weights.insert(vectors.weights.end(), texel_weights.begin(),
                           texel_weights.begin() + texels);
    if (!colours.constant) append_mean(coordinates, texel_weights, colours.mean_weight, vectors);
  }
  return vectors;
}

// Mean in encoded sRGB: the pictures are composited there, and a single kind comes back exact.
BlockColours mean_colours(const ColourKinds& colours, std::span<const std::uint32_t> kinds) {
  std::array<glm::dvec3, 16> sum{};
  std::array<double, 16> total{};
  for (const std::uint32_t kind : kinds) {
    const ColourBlock block = colours[kind];
    for (std::size_t i = 0; i < 16; ++i) {
      const double weight =
          double(colours.blocks.weight[kind]) * double(texel_weight(block.alpha[i]));
      sum[i] += weight * glm::dvec3(block.srgb[i]);
      total[i] += weight;
    }
  }
  BlockColours mean;
  for (std::size_t i = 0; i < 16; ++i) mean[i] = glm::u8vec3(glm::round(sum[i] / total[i]));
  return mean;
}

// The paper's rule: the member nearest to the centroid, in the space where colours are compared.
BlockColours closest_colours(const ColourKinds& colours, std::span<const std::uint32_t> kinds) {
  std::vector<float> weights(kinds.size());
  std::transform(kinds.begin(), kinds.end(), weights.begin(),
                 [&](std::uint32_t kind) { return colours.blocks.weight[kind]; });
  const VectorSet vectors = colour_vectors(colours, kinds, weights);
  std::vector<std::uint32_t> members(kinds.size());
  std::iota(members.begin(), members.end(), 0u);
  const ClusterStatistics statistics = cluster_statistics(vectors, members);
  const std::vector<float> centroid(statistics.mean.begin(), statistics.mean.end());
  const VectorSet unweighted = colour_vectors(colours, kinds, std::vector(kinds.size(), 1.0f));
  const auto nearest = std::min_element(members.begin(), members.end(), [&](auto a, auto b) {
    return distance(unweighted, a, centroid) < distance(unweighted, b, centroid);
  });
  return colours[kinds[*nearest]].srgb;
}

// Reads the kinds of one level's alpha blocks.
struct AlphaKinds {
  const BillboardLevel& level;
  const DistinctBlocks& blocks;
  float mean_weight;

  BlockAlphas operator[](std::uint32_t kind) const {
    return block_alphas(block_texels(level, blocks.first_block[kind]));
  }
};

// Alpha itself is compared, and codewords are mean alphas: along a ray through independent blocks
// that keeps the mean transmittance, a product of (1 - alpha), unbiased. Means of -log(1 - alpha)
// would not.
VectorSet alpha_vectors(const AlphaKinds& alphas, std::span<const std::uint32_t> kinds,
                        std::span<const float> weights) {
  VectorSet vectors{1, 17, {}, {weights.begin(), weights.end()}};
  vectors.values.reserve(kinds.size() * vectors.channels);
  const float mean_scale = std::sqrt(16.0f * alphas.mean_weight);
  for (const std::uint32_t kind : kinds) {
    float mean = 0.0f;
    for (const std::uint8_t alpha : alphas[kind]) {
      vectors.values.push_back(float(alpha) / 255.0f - 0.5f);
      mean += vectors.values.back() / 16.0f;
    }
    vectors.values.push_back(mean * mean_scale);
  }
  return vectors;
}

BlockAlphas mean_alphas(const AlphaKinds& alphas, std::span<const std::uint32_t> kinds) {
  std::array<double, 16> sum{};
  double total = 0.0;
  for (const std::uint32_t kind : kinds) {
    const BlockAlphas alpha = alphas[kind];
    const double weight = double(alphas.blocks.weight[kind]);
    for (std::size_t i = 0; i < 16; ++i) sum[i] += weight * alpha[i];
    total += weight;
  }
  BlockAlphas mean;
  for (std::size_t i = 0; i < 16; ++i) mean[i] = std::uint8_t(std::lround(sum[i] / total));
  return mean;
}

double brightness(const BlockColours& codeword) {
  double sum = 0.0;
  for (const auto& srgb : codeword) sum += 0.299 * srgb.r + 0.587 * srgb.g + 0.114 * srgb.b;
  return sum;
}
double brightness(const BlockAlphas& codeword) {
  return std::accumulate(codeword.begin(), codeword.end(), 0.0);
}

// Numbers codewords by brightness or opacity, so that near numbers look alike.
template <class Codeword>
void sort_codewords(std::vector<Codeword>& codewords, std::vector<std::uint16_t>& indices) {
  std::vector<std::uint16_t> order(codewords.size()), rank(codewords.size());
  std::iota(order.begin(), order.end(), std::uint16_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::uint16_t a, std::uint16_t b) {
    return brightness(codewords[a]) < brightness(codewords[b]);
  });
  std::vector<Codeword> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.push_back(codewords[order[i]]);
    rank[order[i]] = std::uint16_t(i);
  }
  codewords = std::move(sorted);
  for (std::uint16_t& index : indices) index = rank[index];
}

// Codewords from the kinds they stand for, sorted; indices for all blocks.
template <class Result, class MakeCodeword>
Result finish(const DistinctBlocks& blocks, KindCodes codes, std::uint16_t pruned,
              const MakeCodeword& make_codeword, Progress& progress) {
  Result result;
  result.codewords.resize(codes.codewords);
  const Clusters clusters = group_by_codeword(codes.indices, codes.codewords);
  tbb::parallel_for(std::size_t(0), codes.codewords, [&](std::size_t codeword) {
    progress.check();
    result.codewords[codeword] = make_codeword(clusters.members(codeword));
  });
  sort_codewords(result.codewords, codes.indices);
  result.indices = block_codes(blocks, codes.indices, pruned);
  return result;
}

bool all_constant(const BillboardLevel& level, const DistinctBlocks& blocks) {
  return std::all_of(blocks.first_block.begin(), blocks.first_block.end(),
                     [&](auto block) { return is_constant(block_texels(level, block)); });
}

}  // namespace

std::size_t code_units(const BillboardLevel& level) {
  return code_kinds_units(block_count(level), TrainingOptions{});
}

LevelColours code_colours(const BillboardLevel& level, const CompressOptions& options,
                          Progress& progress) {
  const DistinctBlocks blocks = distinct_colours(level, progress);
  const ColourKinds colours{level, blocks, colour_space(options), float(options.block_mean_weight),
                            all_constant(level, blocks)};
  const TrainingOptions training{.codewords = options.colour_codewords};
  KindCodes codes = code_kinds(
      blocks, [&](auto kinds, auto weights) { return colour_vectors(colours, kinds, weights); },
      training, std::size_t(options.training_blocks), progress);
  const bool closest = options.codeword_rule == "closest_block";
  return finish<LevelColours>(
      blocks, std::move(codes), 0,
      [&](auto kinds) {
        return closest ? closest_colours(colours, kinds) : mean_colours(colours, kinds);
      },
      progress);
}

LevelAlphas code_alphas(const BillboardLevel& level, const CompressOptions& options,
                        Progress& progress) {
  const DistinctBlocks blocks = distinct_alphas(level, progress);
  const AlphaKinds alphas{level, blocks, float(options.block_mean_weight)};
  const TrainingOptions training{.codewords = options.alpha_codewords};
  KindCodes codes = code_kinds(
      blocks, [&](auto kinds, auto weights) { return alpha_vectors(alphas, kinds, weights); },
      training, std::size_t(options.training_blocks), progress);
  return finish<LevelAlphas>(
      blocks, std::move(codes), kPrunedIndex,
      [&](auto kinds) { return mean_alphas(alphas, kinds); }, progress);
}

}  // namespace bosk
