#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/package/tree_model.h"

namespace bosk {

// The tree in a package. Any damage, any broken promise of tree_model.h and any excess over the
// limits of format.h throws Error that begins with the file's name; so does a package of a newer
// major version. Memory stays below 1 GiB whatever the bytes are. Any number of threads gives the
// same.
TreeModel read_tree(std::span<const std::byte> package, const std::string& name,
                    unsigned threads = 2);

// The same from a file. Throws Error when it is missing or no regular file.
TreeModel load_tree(const std::filesystem::path& path, unsigned threads = 2);

// All bytes of a package file, at most kMaxFileBytes; for read_tree and for listings.
std::vector<std::byte> load_package_bytes(const std::filesystem::path& path);

}  // namespace bosk
