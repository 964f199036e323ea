#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// The small sections of a package, as section_decode.h reads them. The tree must be valid.
std::vector<std::byte> encode_metadata(const TreeMetadata& metadata);
std::vector<std::byte> encode_scene(const TreeModel& tree);
std::vector<std::byte> encode_levels(const TreeModel& tree);
std::vector<std::byte> encode_atlas(const CodeAtlas& atlas);
std::vector<std::byte> encode_bc3(const CodeAtlas& atlas);
// Cells of a level; `parents`: those of the level before, if that is its parents' level, else none.
std::vector<std::byte> encode_cells(std::span<const std::uint64_t> cells,
                                    std::span<const std::uint64_t> parents);

}  // namespace bosk
