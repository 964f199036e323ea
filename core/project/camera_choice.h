#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/photo/camera_files.h"
#include "core/project/project.h"

namespace bosk {

struct KnownCameras {
  CameraFile file;
  bool completed = false;  // with sizes of photos, so that the file alone is not enough
};
// Where a transforms.json gives no picture sizes, they are taken from the pictures it lists or,
// where those are missing, from the photo of that name. Throws Error when the file can't be read.
KnownCameras known_cameras(const std::filesystem::path& file_or_folder,
                           const std::vector<std::filesystem::path>& photos,
                           const Progress& progress);

// A camera file held against a project's photos, before it is taken for the project's.
struct CameraChoice {
  KnownCameras known;
  std::filesystem::path chosen;        // as it was named
  std::size_t matched = 0;             // photos that have a camera
  std::vector<std::string> unmatched;  // names of those that have none, in order
};
// Reads pictures where sizes are missing, so it may take seconds. Throws Error when the file can't
// be read.
CameraChoice match_cameras(const Project& project, const std::filesystem::path& file_or_folder,
                           const Progress& progress);

// What Project::cameras becomes with the choice. Cameras that had to be completed are stored in the
// project's folder, under a name of their content's hash, so that undoing finds the earlier ones.
std::filesystem::path project_path(const CameraChoice& choice, const Project& project);

}  // namespace bosk
