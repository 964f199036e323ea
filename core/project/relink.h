#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/project/edit.h"
#include "core/project/project.h"

namespace bosk {

// Photos of the project that are no files any more, as the project names them.
std::vector<std::filesystem::path> missing_photos(const Project& project);

struct Relinking {
  SetPhotos edit;         // found photos in their new places, the others as they were
  std::size_t found = 0;  // at least one
  std::vector<std::filesystem::path> still_missing;
};
// Finds missing photos anew, by file name, from one of them or from the folder that they were moved
// to, also where they lie in folders below it as they did before. Throws Error when none is found,
// saying what was looked for.
Relinking relink_photos(const Project& project, const std::filesystem::path& found);

}  // namespace bosk
