#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bosk {

// What files and folders that somebody names at once are good for, told by names and places alone:
//
//   project.json, or a folder that holds one             a project
//   *.json, *.cameramodel, COLMAP's cameras, images,     cameras: the file or, of COLMAP's, its
//     points3D and frames, .txt or .bin                  folder
//   a folder where a camera file lies or, as COLMAP      cameras; photos too where the folder holds
//     leaves it, in sparse/0, sparse, colmap/sparse/0    some
//   a photo by its ending; a folder of photos, or with   photos
//     such a folder called images or photos in it
//
// Anything else is left out, with a sentence that says why.
struct NamedPaths {
  std::filesystem::path project;              // folder; empty: none. The first of several
  std::filesystem::path cameras;              // file or folder; empty: none. The first of several
  std::vector<std::filesystem::path> photos;  // files, sorted, each once
  std::vector<std::string> left_out;
};
NamedPaths sorted_out(const std::vector<std::filesystem::path>& named);

// Files of the folder that may be mattes of these photos, by their names alone and in the photos'
// order; none where one of them is a photo itself, or where the folder holds a project.
std::vector<std::filesystem::path> mattes_for(const std::vector<std::filesystem::path>& photos,
                                              const std::filesystem::path& folder);

// The path that typed or pasted text means: without quotes, blanks around it and file://, with ~ as
// the person's own folder.
std::filesystem::path path_of_text(std::string text);

}  // namespace bosk
