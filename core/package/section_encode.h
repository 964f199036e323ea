#pragma once

#include <cstddef>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// The small sections of a package, as section_decode.h reads them. The tree must be valid.
std::vector<std::byte> encode_metadata(const TreeMetadata& metadata);
std::vector<std::byte> encode_scene(const TreeModel& tree);
std::vector<std::byte> encode_levels(const TreeModel& tree);
std::vector<std::byte> encode_atlas(const CodeAtlas& atlas);
std::vector<std::byte> encode_bc3(const CodeAtlas& atlas);
std::vector<std::byte> encode_cells(const TreeLevel& level);

}  // namespace bosk
