#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/matte/matte.h"
#include "core/project/capture.h"

namespace bosk {

// Where a project's package goes unless a person says otherwise: FOLDER/NAME.bosk.
std::filesystem::path usual_package_path(const Project& project);

// Writes the package, atomically. A file that holds it already keeps its time, so that make and its
// like agree; false then.
bool write_package_file(const std::filesystem::path& path, const std::vector<std::byte>& package);

// Cameras of the views as photographed, in a format of core/photo/camera_files.h, listing the
// photos' own file names. Returns how many.
std::size_t export_cameras(const Photos& views, const Capture& capture, const std::string& format,
                           const std::filesystem::path& output);

// FOLDER/NAME.png for each view: its matte in the pixels of the photo as taken, so that it serves
// beside the original photo. `mattes` in the order of `views`. Returns how many.
std::size_t export_mattes(const Photos& views, const Mattes& mattes,
                          const std::filesystem::path& folder, Progress& progress);

}  // namespace bosk
