// Speed of the codeword search and of a level's compression, beside how good the result is.
// "ns_per_pair" is the time per vector and codeword; goals on two cores: 0.45 with AVX-512, 0.9
// with AVX2.
#include <benchmark/benchmark.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/compress/codebook.h"
#include "core/compress/nearest_codeword.h"
#include "core/compress/rate_distortion.h"
#include "leafy_billboards.h"

namespace bosk {
namespace {

constexpr std::size_t kQueries = 8192;

struct SearchCase {
  std::size_t dimension;
  std::vector<float> codewords, biases, queries;
};

SearchCase search_case(const benchmark::State& state) {
  const auto dimension = std::size_t(state.range(0)), count = std::size_t(state.range(1));
  Random random(1);
  SearchCase result{dimension, std::vector<float>(count * dimension), std::vector<float>(count),
                    std::vector<float>(kQueries * dimension)};
  for (float& x : result.codewords) x = float(random.normal());
  for (float& x : result.queries) x = float(random.normal());
  for (std::size_t i = 0; i < result.codewords.size(); ++i) {
    result.biases[i / dimension] += 0.5f * result.codewords[i] * result.codewords[i];
  }
  return result;
}

// The yardstick: one distance after another, as the definition says.
void search_naively(const SearchCase& problem, std::span<std::uint16_t> indices) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const float* query = problem.queries.data() + i * problem.dimension;
    float best = 3e38f;
    for (std::size_t k = 0; k < problem.biases.size(); ++k) {
      const float* codeword = problem.codewords.data() + k * problem.dimension;
      float square = 0.0f;
      for (std::size_t d = 0; d < problem.dimension; ++d) {
        square += (query[d] - codeword[d]) * (query[d] - codeword[d]);
      }
      if (square < best) indices[i] = std::uint16_t(k);
      best = std::min(best, square);
    }
  }
}

void report(benchmark::State& state, const SearchCase& problem,
            const std::vector<std::uint16_t>& indices) {
  std::vector<std::uint16_t> truth(kQueries);
  search_naively(problem, truth);
  std::size_t right = 0;
  for (std::size_t i = 0; i < kQueries; ++i) right += indices[i] == truth[i];
  const double pairs = double(kQueries) * double(problem.biases.size());
  state.counters["time_per_pair"] =
      benchmark::Counter(pairs * double(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["same_as_naive"] = double(right) / double(kQueries);
}

void naive_search(benchmark::State& state) {
  const SearchCase problem = search_case(state);
  std::vector<std::uint16_t> indices(kQueries);
  for (auto _ : state) search_naively(problem, indices);
  report(state, problem, indices);
}

void search(benchmark::State& state, InstructionSet instructions, bool all_cores) {
  if (instructions > widest_instruction_set()) return state.SkipWithError("not on this processor");
  const SearchCase problem = search_case(state);
  const CodewordTable table =
      make_codeword_table(problem.codewords, problem.biases, int(problem.dimension));
  std::vector<std::uint16_t> indices(kQueries);
  const std::size_t chunk = all_cores ? 512 : kQueries;
  for (auto _ : state) {
    tbb::parallel_for(std::size_t(0), kQueries / chunk, [&](std::size_t i) {
      nearest_codewords(table,
                        std::span(problem.queries)
                            .subspan(i * chunk * problem.dimension, chunk * problem.dimension),
                        std::span(indices).subspan(i * chunk, chunk), instructions);
    });
  }
  report(state, problem, indices);
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({48, 512})->Args({48, 1024})->Args({16, 512});
}

// 12000 blocks: what an option costs and what it gains.
void compress_level(benchmark::State& state, const char* colour_space, const char* rule,
                    double mean_weight) {
  const Billboards trees = testing::leafy_billboards({.cells = 1000, .views = 12});
  const CompressOptions options{.colour_codewords = int(state.range(0)),
                                .alpha_codewords = int(state.range(0)),
                                .colour_space = colour_space,
                                .codeword_rule = rule,
                                .block_mean_weight = mean_weight};
  Progress quiet;
  CodedTextures textures;
  for (auto _ : state) textures = compress_billboards(trees, options, quiet);
  const LevelRateDistortion got = rate_distortion(trees, textures, false, quiet)[0];
  state.counters["colour_db"] = got.colour_psnr_db;
  state.counters["dE76"] = got.colour_delta_e;
  state.counters["alpha_db"] = got.alpha_psnr_db;
  state.counters["block_colour_db"] = got.block_colour_psnr_db;
  state.counters["block_alpha_db"] = got.block_alpha_psnr_db;
  state.counters["bits"] = got.colour_entropy_bits + got.alpha_entropy_bits;
}

void codebook_sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int codewords : {64, 256, 1024, 4096}) benchmark->Arg(codewords);
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
}

struct StackCase {
  double leaves, leaf_size;
};
constexpr std::array<StackCase, 3> kFoliage{{{8, 0.3}, {30, 0.08}, {3, 0.12}}};

enum class AlphaRule { depth_mean_depth, depth_mean_alpha, alpha_mean_alpha };

using Alphas = std::array<double, 16>;

std::vector<Alphas> leafy_alphas(const StackCase& foliage) {
  const BillboardLevel level = testing::leafy_level(
      {.cells = 1500, .views = 8, .leaves = foliage.leaves, .leaf_size = foliage.leaf_size});
  std::vector<Alphas> blocks;
  for (std::size_t block = 0; block < block_count(level); ++block) {
    const BlockTexels texels = block_texels(level, block);
    if (is_pruned(texels)) continue;
    Alphas& alphas = blocks.emplace_back();
    std::transform(texels.begin(), texels.end(), alphas.begin(),
                   [](const glm::u8vec4& texel) { return texel.a / 255.0; });
  }
  return blocks;
}

// Opaque texels count as a transmittance of 2%.
double depth_of(double alpha) { return -std::log(std::max(1.0 - alpha, 0.02)); }

// What each block is coded as, with 512 codewords of 8 bits.
std::vector<Alphas> coded_alphas(const std::vector<Alphas>& blocks, AlphaRule rule, double weight) {
  VectorSet vectors{1, 17, {}, std::vector<float>(blocks.size(), 1.0f)};
  for (const Alphas& block : blocks) {
    double mean = 0.0;
    for (const double alpha : block) {
      const double value = rule == AlphaRule::alpha_mean_alpha ? alpha : depth_of(alpha);
      vectors.values.push_back(float(value));
      mean += value / 16.0;
    }
    vectors.values.push_back(float(mean * std::sqrt(16.0 * weight)));
  }
  Progress quiet;
  const Codebook codebook = train_codebook(vectors, {.codewords = 512}, quiet);
  const auto indices = encode(vectors, search_table(codebook), quiet);
  const Clusters clusters = group_by_codeword(indices, codebook.size());
  std::vector<Alphas> codewords(codebook.size());
  const bool of_depth = rule == AlphaRule::depth_mean_depth;
  for (std::size_t k = 0; k < codewords.size(); ++k) {
    for (std::size_t i = 0; i < 16; ++i) {
      double sum = 0.0;
      for (const auto b : clusters.members(k)) {
        sum += of_depth ? depth_of(blocks[b][i]) : blocks[b][i];
      }
      const double mean = sum / std::max(1.0, double(clusters.members(k).size()));
      codewords[k][i] = std::round(255.0 * (of_depth ? 1.0 - std::exp(-mean) : mean)) / 255.0;
    }
  }
  std::vector<Alphas> coded;
  coded.reserve(indices.size());
  for (const std::uint16_t index : indices) coded.push_back(codewords[index]);
  return coded;
}

// Error of the share of light that passes 5 to 10 random blocks, 16 rays a stack.
void stack(benchmark::State& state, AlphaRule rule, double weight) {
  const auto blocks = leafy_alphas(kFoliage[std::size_t(state.range(0))]);
  std::vector<Alphas> coded;
  for (auto _ : state) coded = coded_alphas(blocks, rule, weight);
  constexpr int kStacks = 20000;
  Random random(7);
  double bias = 0.0, ray_square = 0.0, block_square = 0.0;
  for (int i = 0; i < kStacks; ++i) {
    Alphas truth, got;
    truth.fill(1.0);
    got.fill(1.0);
    for (auto depth = 5 + random.below(6); depth > 0; --depth) {
      const std::size_t block = random.below(blocks.size());
      for (std::size_t t = 0; t < 16; ++t) truth[t] *= 1.0 - blocks[block][t];
      for (std::size_t t = 0; t < 16; ++t) got[t] *= 1.0 - coded[block][t];
    }
    double mean = 0.0;
    for (std::size_t t = 0; t < 16; ++t) {
      mean += (got[t] - truth[t]) / 16.0;
      ray_square += (got[t] - truth[t]) * (got[t] - truth[t]) / 16.0;
    }
    bias += mean;
    block_square += mean * mean;
  }
  state.counters["bias"] = bias / kStacks;
  state.counters["rms_ray"] = std::sqrt(ray_square / kStacks);
  state.counters["rms_block_mean"] = std::sqrt(block_square / kStacks);
}

void foliage(benchmark::internal::Benchmark* benchmark) {
  for (const int kind : {0, 1, 2}) benchmark->Arg(kind);
  benchmark->Unit(benchmark::kMillisecond)->Iterations(1);
}

// Many blocks that all differ: the leaves' textures with noise on top.
void compress_many_blocks(benchmark::State& state) {
  Billboards trees = testing::leafy_billboards({.cells = 300, .views = 10});
  BillboardLevel& level = trees.levels[0];
  const std::vector<glm::u8vec4> few = level.texture;
  level.views.resize(1);
  level.cells.resize(std::size_t(state.range(0)));
  level.texture.resize(level.cells.size() * 16);
  Random random(3);
  for (std::size_t i = 0; i < level.texture.size(); ++i) {
    const auto bits = random.bits();
    glm::u8vec4 texel = few[i % few.size()];
    for (int c = 0; c < 4; ++c) texel[c] = std::uint8_t(texel[c] ^ ((bits >> (8 * c)) & 7));
    level.texture[i] = few[i % few.size()].a > 7 ? texel : glm::u8vec4(0);
  }
  Progress quiet;
  for (auto _ : state) compress_billboards(trees, {}, quiet);
}

BENCHMARK(naive_search)->Apply(sizes);
BENCHMARK_CAPTURE(search, sse4, InstructionSet::baseline, false)->Apply(sizes);
BENCHMARK_CAPTURE(search, avx2, InstructionSet::avx2, false)->Apply(sizes);
BENCHMARK_CAPTURE(search, avx512, InstructionSet::avx512, false)->Apply(sizes);
BENCHMARK_CAPTURE(search, avx2_all_cores, InstructionSet::avx2, true)->Apply(sizes)->UseRealTime();
BENCHMARK_CAPTURE(search, avx512_all_cores, InstructionSet::avx512, true)
    ->Apply(sizes)
    ->UseRealTime();
BENCHMARK_CAPTURE(compress_level, defaults, "lab_log_chroma", "centroid", 4.0)
    ->Apply(codebook_sizes);
BENCHMARK_CAPTURE(compress_level, lab, "lab", "centroid", 4.0)->Apply(codebook_sizes);
BENCHMARK_CAPTURE(compress_level, srgb, "srgb", "centroid", 4.0)->Apply(codebook_sizes);
BENCHMARK_CAPTURE(compress_level, texels_alone, "lab_log_chroma", "centroid", 0.0)
    ->Apply(codebook_sizes);
BENCHMARK_CAPTURE(compress_level, closest_block, "lab_log_chroma", "closest_block", 4.0)
    ->Apply(codebook_sizes);
BENCHMARK_CAPTURE(stack, depth_mean_depth, AlphaRule::depth_mean_depth, 0.0)->Apply(foliage);
BENCHMARK_CAPTURE(stack, depth_mean_alpha, AlphaRule::depth_mean_alpha, 0.0)->Apply(foliage);
BENCHMARK_CAPTURE(stack, alpha_mean_alpha, AlphaRule::alpha_mean_alpha, 0.0)->Apply(foliage);
BENCHMARK_CAPTURE(stack, with_block_mean, AlphaRule::alpha_mean_alpha, 4.0)->Apply(foliage);
BENCHMARK(compress_many_blocks)
    ->Arg(1'000'000)
    ->Arg(5'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

}  // namespace
}  // namespace bosk
