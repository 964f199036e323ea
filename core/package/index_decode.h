#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

// All throw Error on damage (`name` is for the message) and never read beyond `bytes`.

// From the decoded bytes of a LIVE section: 1 for each block that draws, 0 for a pruned one, in
// view order.
std::vector<std::uint8_t> decode_live(std::span<const std::byte> bytes, const IndexShape& shape,
                                      const std::string& name);

// From the decoded bytes of an ALPH or COLR section: indices below `codewords` in cell order, and
// `pruned_value` for blocks that are not live.
std::vector<std::uint16_t> decode_indices(std::span<const std::byte> bytes, const IndexShape& shape,
                                          std::span<const std::uint8_t> live,
                                          std::uint32_t codewords, std::uint16_t pruned_value,
                                          const std::string& name);

}  // namespace bosk
