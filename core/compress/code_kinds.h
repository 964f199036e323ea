#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/compress/blocks.h"
#include "core/compress/codebook.h"

namespace bosk {

// Vectors of some kinds of block, with a weight for each kind.
using MakeVectors =
    std::function<VectorSet(std::span<const std::uint32_t> kinds, std::span<const float> weights)>;

struct KindCodes {
  std::vector<std::uint16_t> indices;  // of each kind
  std::size_t codewords = 0;           // every one is used
};

// Finds the codeword of every kind of block: its own where codewords suffice, else the nearest of a
// codebook trained on a sample.
KindCodes code_kinds(const DistinctBlocks& blocks, const MakeVectors& make_vectors,
                     const TrainingOptions& options, std::size_t training_blocks,
                     Progress& progress);

// Units by which code_kinds advances, at most.
std::size_t code_kinds_units(std::size_t blocks, const TrainingOptions& options);

// For every block the code of its kind, or `pruned`.
std::vector<std::uint16_t> block_codes(const DistinctBlocks& blocks,
                                       std::span<const std::uint16_t> kind_codes,
                                       std::uint16_t pruned);

}  // namespace bosk
