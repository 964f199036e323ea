#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

// The raw bytes of LIVE, ALPH and COLR sections, as index_decode.h reads them.

// All indices in cell order.
std::vector<std::byte> encode_live(std::span<const std::uint16_t> alpha, const IndexShape& shape);

// `indices`: alpha or colour, below `codewords` where alpha is not kPruned. `parents`: null to
// begin each cell on its own; their indices are below `parent_codewords`.
std::vector<std::byte> encode_indices(std::span<const std::uint16_t> indices,
                                      std::span<const std::uint16_t> alpha, const IndexShape& shape,
                                      std::uint32_t codewords, const ParentIndices* parents,
                                      std::uint32_t parent_codewords);

}  // namespace bosk
