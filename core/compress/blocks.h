#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/billboard/billboard.h"
#include "core/compress/colour_space.h"

namespace bosk {

// 4x4 texels, row by row. Blocks of a level are counted [cell][view][block row][block column].
using BlockTexels = std::array<glm::u8vec4, 16>;
using BlockAlphas = std::array<std::uint8_t, 16>;

std::size_t block_count(const BillboardLevel& level);
BlockTexels block_texels(const BillboardLevel& level, std::size_t block);
BlockAlphas block_alphas(const BlockTexels& texels);
bool is_pruned(const BlockTexels& texels);    // alpha 0 everywhere
bool is_constant(const BlockTexels& texels);  // the visible texels have one colour

// What counts of a block's colour. Clear texels take the colour of the visible ones around them,
// since the alpha codeword may let them shine through a little; their own colour never matters.
struct ColourBlock {
  BlockColours srgb{};
  BlockAlphas alpha{};  // 255 throughout where the colour is constant
};
ColourBlock colour_block(const BlockTexels& texels);

// Blocks that are coded as one: kinds in the order of their first block.
inline constexpr std::uint32_t kNoKind = 0xffffffff;  // of a pruned block
struct DistinctBlocks {
  std::vector<std::uint32_t> first_block;    // of each kind
  std::vector<float> weight;                 // of each kind: how often it occurs
  std::vector<std::uint32_t> kind_of_block;  // or kNoKind
};
DistinctBlocks distinct_colours(const BillboardLevel& level, Progress& progress);
DistinctBlocks distinct_alphas(const BillboardLevel& level, Progress& progress);

// At most `limit` kinds with weights that stand for all: kinds are met as often as their weight
// says, at equal steps through the list (systematic sampling), so that common ones are never
// missed.
struct KindSample {
  std::vector<std::uint32_t> kinds;
  std::vector<float> weights;
};
KindSample sample_kinds(const DistinctBlocks& blocks, std::size_t limit);

}  // namespace bosk
