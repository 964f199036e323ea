#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

// The raw bytes of an ALPH or COLR section, as index_decode.h reads them. Indices must be valid
// (model_check.h). `buckets` (1 to 64): kinds of expected codeword that have statistics of their
// own; more pay off for large levels.
std::vector<std::byte> encode_planes(std::span<const std::uint16_t> indices,
                                     const IndexShape& shape);
std::vector<std::byte> encode_ranked_alpha(std::span<const std::uint16_t> indices,
                                           const IndexShape& shape, const NearCodewords& near,
                                           unsigned buckets);
std::vector<std::byte> encode_ranked_colour(std::span<const std::uint16_t> indices,
                                            std::span<const std::uint16_t> alpha_indices,
                                            const IndexShape& shape, const NearCodewords& near,
                                            unsigned buckets);

}  // namespace bosk
