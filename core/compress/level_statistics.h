#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/billboard/billboard.h"
#include "core/compress/compress.h"

namespace bosk {

// What one level of the billboards holds.
struct LevelStatistics {
  int level = 0;
  std::size_t cells = 0, views = 0;
  std::size_t textures = 0;     // cells times views
  std::size_t kept = 0;         // textures that aren't pruned
  std::size_t blocks = 0;       // of 4x4 texels, pruned ones too
  std::size_t raw_bytes = 0;    // 4 a texel
  std::size_t index_bytes = 0;  // two indices of 2 bytes a block: as they are drawn
  double pruned_share() const {
    return textures == 0 ? 0.0 : 1.0 - double(kept) / double(textures);
  }
};
std::vector<LevelStatistics> level_statistics(const Billboards& billboards);

// The cell, by its place, whose textures are the most opaque in all; 0 where there is none. Of many
// cells only every few are looked at, so that it takes milliseconds.
std::size_t fullest_cell(const BillboardLevel& level);

// Textures that have any block that isn't pruned, of a level's alpha indices.
std::size_t textures_kept(std::span<const std::uint16_t> alpha_indices,
                          std::size_t blocks_per_texture);

}  // namespace bosk
