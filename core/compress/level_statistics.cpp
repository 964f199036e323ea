#include "core/compress/level_statistics.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/compress/blocks.h"

namespace bosk {
namespace {

std::size_t textures_kept(const BillboardLevel& level) {
  const std::size_t textures = level.cells.size() * level.views.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < textures; ++i) {
    const auto first = level.texture.begin() + std::ptrdiff_t(i * level.texture_size());
    kept += std::any_of(first, first + std::ptrdiff_t(level.texture_size()),
                        [](const glm::u8vec4& texel) { return texel.a > 0; })
                ? 1
                : 0;
  }
  return kept;
}

}  // namespace

std::size_t textures_kept(std::span<const std::uint16_t> alpha_indices,
                          std::size_t blocks_per_texture) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i + blocks_per_texture <= alpha_indices.size(); i += blocks_per_texture) {
    const auto texture = alpha_indices.subspan(i, blocks_per_texture);
    kept += std::any_of(texture.begin(), texture.end(),
                        [](std::uint16_t index) { return index != kPrunedIndex; })
                ? 1
                : 0;
  }
  return kept;
}

std::size_t fullest_cell(const BillboardLevel& level) {
  constexpr std::size_t kLookedAt = 20'000;
  const std::size_t texels = level.views.size() * level.texture_size();
  const std::size_t step = std::max<std::size_t>(1, level.cells.size() / kLookedAt);
  std::size_t fullest = 0;
  std::uint64_t most = 0;
  for (std::size_t cell = 0; cell < level.cells.size(); cell += step) {
    std::uint64_t opacity = 0;
    for (std::size_t i = 0; i < texels; ++i) opacity += level.texture[cell * texels + i].a;
    if (opacity > most) most = opacity, fullest = cell;
  }
  return fullest;
}

std::vector<LevelStatistics> level_statistics(const Billboards& billboards) {
  std::vector<LevelStatistics> statistics(billboards.levels.size());
  tbb::parallel_for(std::size_t(0), statistics.size(), [&](std::size_t i) {
    const BillboardLevel& level = billboards.levels[i];
    LevelStatistics& row = statistics[i];
    row.level = level.level;
    row.cells = level.cells.size();
    row.views = level.views.size();
    row.textures = row.cells * row.views;
    row.kept = textures_kept(level);
    row.blocks = block_count(level);
    row.raw_bytes = level.texture.size() * sizeof(glm::u8vec4);
    row.index_bytes = row.blocks * 2 * sizeof(std::uint16_t);
  });
  return statistics;
}

}  // namespace bosk
