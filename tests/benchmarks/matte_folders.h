#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/matte/matte.h"

namespace bosk {

// Of a file of one channel, or the alpha of one of four.
Image<float> read_alpha(const std::filesystem::path& path);

// The folder's files by name without ending; none without a folder.
std::map<std::string, std::filesystem::path> files_by_name(const std::filesystem::path& folder);

// The folder's images as photos; `cameras_path` (may be empty) gives their poses, and their lenses
// only as pinholes, since the photos are used as they are.
Photos read_photos(const std::filesystem::path& folder, const std::string& cameras_path);
Scribbles read_scribbles(const std::filesystem::path& folder);

// FOLDER... [--cameras=FILE] [--matte.name=value ...]. Throws Error for an option that there isn't.
struct MatteArguments {
  std::vector<std::string> folders;
  std::string cameras;
  MatteOptions options;
};
MatteArguments matte_arguments(int argc, char** argv);

}  // namespace bosk
