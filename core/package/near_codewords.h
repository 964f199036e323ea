#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// For every codeword those that look most like it, nearest first, itself included. Both ends of the
// index coding derive it from the codebook, so it costs no bytes.
struct NearCodewords {
  std::uint32_t count = 0;           // codewords
  std::uint32_t length = 0;          // of each list: min(asked, count)
  std::vector<std::uint16_t> lists;  // [codeword][rank]

  std::span<const std::uint16_t> of(std::uint32_t codeword) const {
    return std::span(lists).subspan(std::size_t(codeword) * length, length);
  }
};

enum class CodewordKind { alpha, colour };

// Nearness is the sum of absolute differences over the tile's texels (8-bit, exact on any machine),
// ties by number. Only numbers within 512 are candidates: codewords are numbered so that near
// numbers look alike, and loading stays fast at 4096 codewords. length: 1 to 64. The range must lie
// in the atlas.
NearCodewords near_codewords(const CodeAtlas& atlas, const CodeRange& codes, CodewordKind kind,
                             std::uint32_t length);

}  // namespace bosk
