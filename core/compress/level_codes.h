#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/billboard/billboard.h"
#include "core/compress/blocks.h"
#include "core/compress/compress.h"

namespace bosk {

// One level's codewords and, for every block, the codeword that stands for it: kPrunedIndex (alpha)
// or 0 (colour) where the block is pruned. Every codeword is used.
struct LevelColours {
  std::vector<BlockColours> codewords;
  std::vector<std::uint16_t> indices;
};
struct LevelAlphas {
  std::vector<BlockAlphas> codewords;
  std::vector<std::uint16_t> indices;
};
std::size_t code_units(const BillboardLevel& level);  // by which each of these advances, at most
LevelColours code_colours(const BillboardLevel& level, const CompressOptions& options,
                          Progress& progress);
LevelAlphas code_alphas(const BillboardLevel& level, const CompressOptions& options,
                        Progress& progress);

}  // namespace bosk
