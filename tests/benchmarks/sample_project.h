#pragma once

#include <filesystem>

#include "core/phantom/phantom.h"
#include "core/project/new_project.h"

namespace bosk {

// A made-up capture in FOLDER/capture and a project of it, with cameras and, where wanted, true
// mattes, in FOLDER/tree, which is returned.
inline std::filesystem::path sample_project(const std::filesystem::path& folder,
                                            const PhantomOptions& options, bool with_mattes) {
  Progress quiet;
  write_phantom(folder / "capture", make_phantom(options, quiet), quiet);
  NewProject wanted;
  wanted.folder = folder / "tree";
  wanted.photos = {folder / "capture" / "photos"};
  wanted.cameras = folder / "capture" / "transforms.json";
  if (with_mattes) wanted.mattes = folder / "capture" / "mattes";
  make_project(wanted, {}, false, quiet);
  return wanted.folder;
}

}  // namespace bosk
