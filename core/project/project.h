#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/project/recipe.h"

namespace bosk {

// A capture on disk: FOLDER/project.json says where its photos are and how to work on them,
// FOLDER/cache holds what the stages made. Paths are relative to the folder, so that it moves
// together with its photos; an empty path means none.
struct Project {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> photos;
  std::filesystem::path cameras;    // file or folder
  std::filesystem::path mattes;     // folder
  std::filesystem::path scribbles;  // folder
  Recipe recipe;

  // Where a path of the project is, also before the folder is made.
  std::filesystem::path absolute(const std::filesystem::path& path) const;
  std::filesystem::path cache_folder() const { return folder / "cache"; }
  // The folder's own name: what the tree is called unless the recipe says otherwise.
  std::string name() const;
};

// Throws Error when the folder holds no project, the file is damaged, or a newer Bosk wrote it.
Project read_project(const std::filesystem::path& folder);
// Atomically; leaves the file alone when nothing changed.
void save_project(const Project& project);
bool holds_project(const std::filesystem::path& folder);

}  // namespace bosk
