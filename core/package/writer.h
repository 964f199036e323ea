#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/base/progress.h"
#include "core/package/tree_model.h"

namespace bosk {

// The bytes of a `.bosk` package; the same bytes for the same tree, on any machine and at any
// thread count, as long as the zstd library is the same. Throws Error when the tree breaks a
// promise of tree_model.h or a limit of format.h.
std::vector<std::byte> package_bytes(const TreeModel& tree, Progress& progress);

// The same into a file, atomically.
void write_package(const std::filesystem::path& path, const TreeModel& tree, Progress& progress);

}  // namespace bosk
