#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/matte/strokes.h"
#include "core/project/calibration_inputs.h"
#include "core/project/recipe.h"

namespace bosk {

// How far a project holds what its journal of edits says (journal.h).
struct JournalPlace {
  std::uint64_t id = 0;   // of the journal; 0: the project has none
  std::uint64_t end = 0;  // bytes of it that the project holds
  bool operator==(const JournalPlace&) const = default;
};

// A capture on disk: FOLDER/project.json says where its photos are and how to work on them,
// FOLDER/cache holds what the stages made. Paths are relative to the folder, so that it moves
// together with its photos; an empty path means none.
struct Project {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> photos;
  std::filesystem::path cameras;    // file or folder; none: calibration finds them
  std::filesystem::path mattes;     // folder
  std::filesystem::path scribbles;  // folder
  Strokes strokes;                  // drawn in the workstation, over the files in `scribbles`
  CalibrationInputs calibration;    // used where there is no camera file
  Recipe recipe;
  JournalPlace journal;

  // Where a path of the project is, also before the folder is made.
  std::filesystem::path absolute(const std::filesystem::path& path) const;
  // The same the other way: a path as typed, as the project keeps it.
  std::filesystem::path relative(const std::filesystem::path& path) const;
  std::filesystem::path cache_folder() const { return folder / "cache"; }
  // The folder's own name: what the tree is called unless the recipe says otherwise.
  std::string name() const;
};

// With the edits that its journal holds beyond project.json, also those of a workstation that was
// killed or is at work. Throws Error when the folder holds no project, project.json is damaged, or
// a newer Bosk wrote it.
Project read_project(const std::filesystem::path& folder);
// Atomically; leaves the file alone when nothing changed.
void save_project(const Project& project);
bool holds_project(const std::filesystem::path& folder);

}  // namespace bosk
