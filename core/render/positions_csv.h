#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/render/forest.h"
#include "core/render/terrain.h"

namespace bosk {

// Trees where a table of positions puts them. The first line names the columns, in any order:
//
//   x, y       metres east and north; needed
//   z          metres; without it (or where the field is empty) trees stand on the terrain
//   turn_deg   degrees about the trunk, from east towards north; 0
//   scale      above 0; 1
//   tree       a package's name, or its number on the command line from 1; 1
//
// Other columns are passed over, as are empty lines and those that begin with #. Fields are parted
// by commas and may stand in double quotes. Throws Error that begins with `name` and the line.
std::vector<TreeInstance> parse_positions(std::string_view text, const std::string& name,
                                          std::span<const std::string> tree_names,
                                          const Terrain& terrain);

// The same from a file of at most 1 GiB.
std::vector<TreeInstance> read_positions(const std::filesystem::path& path,
                                         std::span<const std::string> tree_names,
                                         const Terrain& terrain);

}  // namespace bosk
