#include "core/compress/nearest_codeword.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace bosk {
namespace {

constexpr int kPanel = 32;  // codewords side by side in the table

// Vectors of kLanes floats; each maps to one register of the instruction set compiled for. Spelled
// out because GCC drops the attribute where its argument depends on a template parameter.
template <int kLanes>
struct Simd;
template <>
struct Simd<4> {
  typedef float Float __attribute__((vector_size(16), may_alias));
  typedef std::int32_t Int __attribute__((vector_size(16)));
};
template <>
struct Simd<8> {
  typedef float Float __attribute__((vector_size(32), may_alias));
  typedef std::int32_t Int __attribute__((vector_size(32)));
};
template <>
struct Simd<16> {
  typedef float Float __attribute__((vector_size(64), may_alias));
  typedef std::int32_t Int __attribute__((vector_size(64)));
};

// The scores of kRows queries against kWide * kLanes codewords, in registers.
template <int kLanes, int kWide, int kRows>
struct Tile {
  typename Simd<kLanes>::Float score[kRows][kWide];
};

// Smallest score of each lane so far, and its vector of codewords: first codeword / kLanes.
template <int kLanes, int kRows>
struct Minima {
  typename Simd<kLanes>::Float score[kRows];
  typename Simd<kLanes>::Int vector[kRows];
};

// `panel` points to the biases of the tile's first codeword.
template <int kLanes, int kWide, int kRows>
[[gnu::always_inline]] inline void score_tile(const float* panel, int dimension,
                                              const float* const* rows,
                                              Tile<kLanes, kWide, kRows>& tile) {
  using Float = typename Simd<kLanes>::Float;
#pragma GCC unroll 16
  for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 16
    for (int wide = 0; wide < kWide; ++wide) {
      tile.score[row][wide] =
          *reinterpret_cast<const Float*>(panel + std::ptrdiff_t(wide) * kLanes);
    }
  }
  for (int d = 0; d < dimension; ++d) {
    panel += kPanel;
    Float codeword[kWide];
#pragma GCC unroll 16
    for (int wide = 0; wide < kWide; ++wide) {
      codeword[wide] = *reinterpret_cast<const Float*>(panel + std::ptrdiff_t(wide) * kLanes);
    }
#pragma GCC unroll 16
    for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 16
      for (int wide = 0; wide < kWide; ++wide) {
        tile.score[row][wide] -= rows[row][d] * codeword[wide];
      }
    }
  }
}

// Strictly smaller only, so that each lane keeps its lowest codeword.
template <int kLanes, int kWide, int kRows>
[[gnu::always_inline]] inline void keep_smaller(const Tile<kLanes, kWide, kRows>& tile, int vector,
                                                Minima<kLanes, kRows>& minima) {
#pragma GCC unroll 16
  for (int row = 0; row < kRows; ++row) {
#pragma GCC unroll 16
    for (int wide = 0; wide < kWide; ++wide) {
      const auto smaller = tile.score[row][wide] < minima.score[row];
      minima.score[row] = smaller ? tile.score[row][wide] : minima.score[row];
      const typename Simd<kLanes>::Int current = vector + wide - typename Simd<kLanes>::Int{};
      minima.vector[row] = smaller ? current : minima.vector[row];
    }
  }
}

template <int kLanes, int kRows>
[[gnu::always_inline]] inline std::uint16_t winner(const Minima<kLanes, kRows>& minima, int row) {
  std::array<float, kLanes> scores;
  std::array<std::int32_t, kLanes> vectors;
  std::memcpy(scores.data(), &minima.score[row], sizeof(scores));
  std::memcpy(vectors.data(), &minima.vector[row], sizeof(vectors));
  std::size_t best = 0;
  for (std::size_t lane = 1; lane < kLanes; ++lane) {
    const bool tie = scores[lane] == scores[best] && vectors[lane] < vectors[best];
    if (scores[lane] < scores[best] || tie) best = lane;
  }
  return static_cast<std::uint16_t>(std::size_t(vectors[best]) * kLanes + best);
}

template <int kLanes, int kWide, int kRows>
[[gnu::always_inline]] inline void search_rows(const CodewordTable& table, const float* const* rows,
                                               std::uint16_t* winners) {
  constexpr int kStep = kLanes * kWide;
  Minima<kLanes, kRows> minima;
  for (int row = 0; row < kRows; ++row) {
    minima.score[row] = typename Simd<kLanes>::Float{} + 3e38f;
    minima.vector[row] = typename Simd<kLanes>::Int{};
  }
  const float* panel = table.lanes.front().lane.data();
  const int codewords = static_cast<int>(table.count);
  for (int first = 0; first < codewords; first += kPanel) {
    for (int offset = 0; offset < kPanel; offset += kStep) {
      Tile<kLanes, kWide, kRows> tile;
      score_tile<kLanes, kWide, kRows>(panel + offset, table.dimension, rows, tile);
      keep_smaller<kLanes, kWide, kRows>(tile, (first + offset) / kLanes, minima);
    }
    panel += std::ptrdiff_t(kPanel) * (table.dimension + 1);
  }
  for (int row = 0; row < kRows; ++row) winners[row] = winner<kLanes, kRows>(minima, row);
}

// kRows queries at a time; a last group that isn't full repeats its last query.
template <int kLanes, int kWide, int kRows>
[[gnu::always_inline]] inline void search(const CodewordTable& table,
                                          std::span<const float> queries,
                                          std::span<std::uint16_t> indices) {
  const auto dimension = static_cast<std::size_t>(table.dimension);
  for (std::size_t first = 0; first < indices.size(); first += kRows) {
    const float* rows[kRows];
    std::uint16_t winners[kRows];
    const std::size_t filled = std::min<std::size_t>(kRows, indices.size() - first);
    for (std::size_t row = 0; row < kRows; ++row) {
      rows[row] = queries.data() + (first + std::min(row, filled - 1)) * dimension;
    }
    search_rows<kLanes, kWide, kRows>(table, rows, winners);
    std::copy_n(winners, filled, indices.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

// Tiles are as large as the registers of each instruction set: 32 of 16 floats, 16 of 8, 16 of 4.
// Clang 14 cannot ask which of these levels the processor has, so it gets the baseline only.
#if defined(__x86_64__) && !defined(__clang__)
[[gnu::target("arch=x86-64-v4,prefer-vector-width=512")]] void search_avx512(
    const CodewordTable& table, std::span<const float> queries, std::span<std::uint16_t> indices) {
  search<16, 2, 12>(table, queries, indices);
}
[[gnu::target("arch=x86-64-v3")]] void search_avx2(const CodewordTable& table,
                                                   std::span<const float> queries,
                                                   std::span<std::uint16_t> indices) {
  search<8, 2, 6>(table, queries, indices);
}
#endif
void search_baseline(const CodewordTable& table, std::span<const float> queries,
                     std::span<std::uint16_t> indices) {
  search<4, 2, 4>(table, queries, indices);
}

}  // namespace

CodewordTable make_codeword_table(std::span<const float> codewords, std::span<const float> biases,
                                  int dimension) {
  assert(!biases.empty() && biases.size() < 65536);
  assert(codewords.size() == biases.size() * static_cast<std::size_t>(dimension));
  CodewordTable table;
  table.dimension = dimension;
  table.count = biases.size();
  const std::size_t steps = static_cast<std::size_t>(dimension) + 1;
  const std::size_t panels = (table.count + kPanel - 1) / kPanel;
  table.lanes.resize(panels * steps);
  for (std::size_t slot = 0; slot < panels * kPanel; ++slot) {
    const std::size_t codeword = std::min(slot, table.count - 1);
    CodewordLanes* panel = &table.lanes[slot / kPanel * steps];
    panel[0].lane[slot % kPanel] = biases[codeword];
    for (std::size_t d = 1; d < steps; ++d) {
      panel[d].lane[slot % kPanel] = codewords[codeword * (steps - 1) + d - 1];
    }
  }
  return table;
}

InstructionSet widest_instruction_set() {
#if defined(__x86_64__) && !defined(__clang__)
  if (__builtin_cpu_supports("x86-64-v4")) return InstructionSet::avx512;
  if (__builtin_cpu_supports("x86-64-v3")) return InstructionSet::avx2;
#endif
  return InstructionSet::baseline;
}

void nearest_codewords(const CodewordTable& table, std::span<const float> queries,
                       std::span<std::uint16_t> indices,
                       [[maybe_unused]] InstructionSet instructions) {
  assert(queries.size() == indices.size() * static_cast<std::size_t>(table.dimension));
#if defined(__x86_64__) && !defined(__clang__)
  if (instructions == InstructionSet::avx512) return search_avx512(table, queries, indices);
  if (instructions == InstructionSet::avx2) return search_avx2(table, queries, indices);
#endif
  search_baseline(table, queries, indices);
}

void nearest_codewords(const CodewordTable& table, std::span<const float> queries,
                       std::span<std::uint16_t> indices) {
  nearest_codewords(table, queries, indices, widest_instruction_set());
}

}  // namespace bosk
