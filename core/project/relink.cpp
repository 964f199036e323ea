#include "core/project/relink.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/system_error.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

// The folder of the found photo, and above it as long as the missing photo's folders have the same
// names: photos/row_1/a.jpg found as /disk/row_1/a.jpg gives /disk/row_1 and /disk.
Paths folders_of_found(const fs::path& missing, const fs::path& found) {
  Paths folders;
  fs::path old_folder = missing, new_folder = found;
  while (!old_folder.filename().empty() && old_folder.filename() == new_folder.filename() &&
         new_folder != new_folder.parent_path()) {
    old_folder = old_folder.parent_path();
    new_folder = new_folder.parent_path();
    folders.push_back(new_folder);
  }
  return folders;
}

Paths folders_to_search(const Project& project, const Paths& missing, const fs::path& found) {
  std::error_code none;
  if (fs::is_directory(found, none)) return {found};
  for (const fs::path& photo : missing) {
    if (photo.filename() != found.filename()) continue;
    return folders_of_found(project.absolute(photo), found);
  }
  throw Error(printable(found.string()) +
              ": none of the missing photos has this name; choose one of them, such as " +
              printable(missing.front().filename().string()) + ", or its folder");
}

// Where the photo lies in the folder: by as many of its last names as fit. Empty: nowhere.
fs::path place_in(const fs::path& folder, const fs::path& photo) {
  fs::path ending, place;
  for (fs::path rest = photo; rest.has_filename() && rest.filename() != "..";
       rest = rest.parent_path()) {
    ending = ending.empty() ? rest.filename() : rest.filename() / ending;
    if (is_file(folder / ending)) place = folder / ending;
  }
  return place;
}

fs::path place_in(const Paths& folders, const fs::path& photo) {
  for (const fs::path& folder : folders) {
    const fs::path place = place_in(folder, photo);
    if (!place.empty()) return place;
  }
  return {};
}

}  // namespace

Paths missing_photos(const Project& project) {
  Paths missing;
  std::copy_if(project.photos.begin(), project.photos.end(), std::back_inserter(missing),
               [&](const fs::path& photo) { return !is_file(project.absolute(photo)); });
  return missing;
}

Relinking relink_photos(const Project& project, const fs::path& found) {
  const Paths missing = missing_photos(project);
  if (missing.empty()) throw Error("no photo is missing");
  const fs::path place = fs::absolute(found).lexically_normal();
  const Paths folders = folders_to_search(project, missing, place);
  Relinking relinking;
  relinking.edit = photos_edit(project, project.photos);
  for (fs::path& photo : relinking.edit.after) {
    if (is_file(project.absolute(photo))) continue;
    const fs::path there = place_in(folders, photo);
    if (there.empty()) {
      relinking.still_missing.push_back(photo);
      continue;
    }
    photo = project.relative(there);
    ++relinking.found;
  }
  if (relinking.found > 0) return relinking;
  throw Error(printable(found.string()) + ": holds none of the missing photos, such as " +
              printable(missing.front().filename().string()) + "; choose the folder they are in");
}

}  // namespace bosk
