#pragma once

#include <filesystem>
#include <vector>

#include "core/base/progress.h"
#include "core/project/project.h"

namespace bosk {

// What a user names to make a project; paths as typed. Empty: not given.
struct NewProject {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> photos;  // files, or folders of photos
  std::filesystem::path cameras, mattes, scribbles;
};

// Makes the project on disk, all at once or, when it throws, not at all. Without cameras it holds
// photos alone, at least one, and no stage can run yet. Without photos, those that a
// transforms.json lists are taken; without mattes and strokes, its masks or the photos' own alpha
// channels. A camera file that gives no picture sizes is completed and stored with the project.
// Throws Error naming what is missing: files, cameras of the photos' names, or at least two usable
// photos. `replace`: describe an existing project anew; what its cache holds stays of use. Its
// photos are taken where neither the user nor the camera file names any, strokes drawn on photos of
// the same names are kept, and the history of its edits ends. Throws Error of kind temporary when
// another process works on it.
Project make_project(const NewProject& wanted, const Recipe& recipe, bool replace,
                     const Progress& progress);

}  // namespace bosk
