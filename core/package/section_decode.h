#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// The small sections of a package, from their decoded bytes (README.md draws them). All throw Error
// on damage; a count is compared with the bytes there are before anything is allocated.

TreeMetadata decode_metadata(std::span<const std::byte> bytes);
void decode_scene(std::span<const std::byte> bytes,
                  TreeModel& tree);  // origin, size, view positions
CodeAtlas decode_atlas(std::span<const std::byte> texels, std::span<const std::byte> bc3);

// A level as the table tells it: everything but cells and indices.
struct LevelFrame {
  TreeLevel level;
  std::uint64_t cell_count = 0;
};
std::vector<LevelFrame> decode_levels(std::span<const std::byte> bytes);

// `parents`: the cells of the level before, if that is its parents' level, else none.
std::vector<std::uint64_t> decode_cells(std::span<const std::byte> bytes, const LevelFrame& frame,
                                        std::span<const std::uint64_t> parents);

}  // namespace bosk
