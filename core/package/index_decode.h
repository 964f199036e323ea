#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

// Indices from the decoded bytes of an ALPH or COLR section; `name` is for messages. Throws Error
// on damage and never reads beyond `bytes`; indices from planes are still to be checked
// (model_check.h).
std::vector<std::uint16_t> decode_alpha_indices(std::span<const std::byte> bytes,
                                                const IndexShape& shape, const CodeAtlas& atlas,
                                                const CodeRange& codes, const std::string& name);
std::vector<std::uint16_t> decode_colour_indices(std::span<const std::byte> bytes,
                                                 const IndexShape& shape, const CodeAtlas& atlas,
                                                 const CodeRange& codes,
                                                 std::span<const std::uint16_t> alpha_indices,
                                                 const std::string& name);

}  // namespace bosk
