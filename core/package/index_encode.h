#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

// The raw bytes of LIVE, ALPH and COLR sections, as index_decode.h reads them.

// 1 for each alpha index that is not kPruned; both in view order.
std::vector<std::uint8_t> live_blocks(std::span<const std::uint16_t> alpha_in_view_order);
std::vector<std::byte> encode_live(std::span<const std::uint8_t> live, const IndexShape& shape);

// `indices` in view order and below `codewords` where live. `ranks` (1 to 255): length of the
// lists; `buckets` (1 to 64): kinds of index before that have statistics of their own. More of both
// pay off in large levels.
std::vector<std::byte> encode_planes(std::span<const std::uint16_t> indices,
                                     std::span<const std::uint8_t> live);
std::vector<std::byte> encode_ranked(std::span<const std::uint16_t> indices,
                                     std::span<const std::uint8_t> live, const IndexShape& shape,
                                     std::uint32_t codewords, unsigned ranks, unsigned buckets);

}  // namespace bosk
