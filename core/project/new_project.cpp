#include "core/project/new_project.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/photo/camera_files.h"
#include "core/photo/decode.h"
#include "core/photo/photo_format.h"
#include "core/project/camera_choice.h"
#include "core/project/capture.h"
#include "core/project/lock.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;

Paths photos_in(const fs::path& folder) {
  std::error_code failure;
  Paths photos;
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const bool hidden = entry.path().filename().string().rfind('.', 0) == 0;
    if (!hidden && entry.is_regular_file() && has_photo_ending(entry.path())) {
      photos.push_back(entry.path());
    }
  }
  if (failure) throw system_error(folder, "read", failure.value());
  if (photos.empty()) throw Error(printable(folder.string()) + ": holds no photos");
  return photos;
}

void require_existence(const fs::path& path) {
  std::error_code none;
  if (!path.empty() && !fs::exists(path, none)) throw system_error(path, "read", ENOENT);
}

void require_folder(const fs::path& path, const std::string& what) {
  require_existence(path);
  if (!path.empty() && !fs::is_directory(path)) {
    throw Error(printable(path.string()) + ": is no folder; give the folder that holds the " +
                what);
  }
}

Paths expanded(const Paths& named) {
  Paths photos;
  for (const fs::path& path : named) {
    require_existence(path);
    if (fs::is_directory(path)) {
      const Paths inside = photos_in(path);
      photos.insert(photos.end(), inside.begin(), inside.end());
    } else {
      photos.push_back(path);
    }
  }
  return photos;
}

// The one folder that all the files lie in; empty when there is none.
fs::path common_folder(const Paths& files) {
  std::set<fs::path> folders;
  for (const fs::path& file : files) {
    if (file.empty()) return {};
    folders.insert(file.parent_path());
  }
  if (folders.size() != 1) return {};
  return folders.begin()->empty() ? fs::path(".") : *folders.begin();
}

Paths existing(const Paths& files) {
  Paths found;
  std::error_code none;
  for (const fs::path& file : files) {
    if (!file.empty() && fs::is_regular_file(file, none)) found.push_back(file);
  }
  return found;
}

bool has_alpha(const fs::path& photo, const Progress& progress) {
  try {
    return decode_photo(photo, {}, progress).has_alpha();
  } catch (const Error&) {
    return false;  // the import will say what is wrong with it
  }
}

// Where mattes may be found when the user named none.
fs::path found_mattes(const CameraFile& cameras, const Paths& photos, const Progress& progress) {
  const Paths masks = existing(cameras.masks);
  if (!masks.empty()) return common_folder(masks);
  return has_alpha(photos.front(), progress) ? common_folder(photos) : fs::path();
}

void check_named(const NewProject& wanted, bool replace) {
  if (!replace && holds_project(wanted.folder)) {
    throw Error(printable(wanted.folder.string()) +
                ": holds a project already; choose another folder, or give --replace");
  }
  require_existence(wanted.cameras);
  require_folder(wanted.mattes, "mattes");
  require_folder(wanted.scribbles, "strokes");
}

// The project that is made anew, where it can be read: its photos and strokes are of use.
Project earlier_project(const fs::path& folder) {
  try {
    if (holds_project(folder)) return read_project(folder);
  } catch (const Error&) {
    // Being made anew is the remedy for it
  }
  return {};
}

KnownCameras cameras_of(const NewProject& wanted, const Paths& photos, const Progress& progress) {
  return wanted.cameras.empty() ? KnownCameras() : known_cameras(wanted.cameras, photos, progress);
}

Paths chosen_photos(const Paths& named, const CameraFile& cameras, const Project& earlier) {
  if (!named.empty()) return named;
  Paths photos = existing(cameras.images);
  if (photos.empty()) {
    for (const fs::path& photo : earlier.photos) photos.push_back(earlier.absolute(photo));
  }
  return photos;
}

void require_photos(const NewProject& wanted, const Paths& photos) {
  if (!photos.empty()) return;
  throw Error(wanted.cameras.empty()
                  ? "no photos given; name the photos or their folder"
                  : "no photos given, and " + printable(wanted.cameras.string()) +
                        " lists none that exist; name the photos or their folder");
}

// Strokes on photos that the project still has.
Strokes kept_strokes(const Strokes& strokes, const Project& project) {
  Strokes kept;
  for (const std::string& name : photo_names(project)) {
    const auto drawn = strokes.find(name);
    if (drawn != strokes.end()) kept.insert(*drawn);
  }
  return kept;
}

Project planned_project(const NewProject& wanted, const CameraFile& cameras, const Paths& photos,
                        const Progress& progress) {
  const bool none_given = wanted.mattes.empty() && wanted.scribbles.empty();
  Project project;
  project.folder = wanted.folder;
  for (const fs::path& photo : photos) project.photos.push_back(project.relative(photo));
  std::sort(project.photos.begin(), project.photos.end());
  project.cameras = project.relative(wanted.cameras);
  project.mattes =
      project.relative(none_given ? found_mattes(cameras, photos, progress) : wanted.mattes);
  project.scribbles = project.relative(wanted.scribbles);
  return project;
}

}  // namespace

Project make_project(const NewProject& wanted, const Recipe& recipe, bool replace,
                     const Progress& progress) {
  check_named(wanted, replace);
  std::optional<ProjectLock> lock;
  if (holds_project(wanted.folder)) lock.emplace(wanted.folder);
  const Project earlier = earlier_project(wanted.folder);
  const Paths named = expanded(wanted.photos);
  const KnownCameras known = cameras_of(wanted, named, progress);
  const Paths photos = chosen_photos(named, known.file, earlier);
  require_photos(wanted, photos);

  Project project = planned_project(wanted, known.file, photos, progress);
  project.recipe = recipe;
  if (project.recipe.pack.name.empty()) project.recipe.pack.name = project.name();
  project.strokes = kept_strokes(earlier.strokes, project);
  if (!wanted.cameras.empty()) gather_capture(project, known.file.cameras);

  make_folder(wanted.folder);
  if (known.completed) {
    project.cameras = "cameras.json";
    write_cameras(known.file.cameras, "transforms", project.absolute(project.cameras));
  }
  save_project(project);
  return project;
}

}  // namespace bosk
