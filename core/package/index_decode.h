#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

struct LevelIndices {
  std::vector<std::uint16_t> alpha, colour;  // as in TreeLevel
};

// Indices of one level from the decoded bytes of its ALPH and COLR sections. `frame` gives the
// level's number and its code ranges, which must lie in the atlas. Throws Error on damage and never
// reads beyond the bytes; indices that came as planes are still to be checked (model_check.h).
LevelIndices decode_level_indices(std::span<const std::byte> alpha_bytes,
                                  std::span<const std::byte> colour_bytes, const IndexShape& shape,
                                  const CodeAtlas& atlas, const TreeLevel& frame);

}  // namespace bosk
