#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace bosk {

struct Workspace;

// Each is one edit, told in the notices of step Photos.

// Those that the project doesn't have yet; its photos stay sorted by path.
void add_photos(Workspace& workspace, const std::vector<std::filesystem::path>& files);
// As the project names them.
void remove_photos(Workspace& workspace, const std::set<std::filesystem::path>& photos);
// Finds missing photos by where one of them, or their folder, is now.
void find_moved_photos(Workspace& workspace, const std::filesystem::path& found);

}  // namespace bosk
