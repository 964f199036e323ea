#include "core/project/new_project.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/photo/camera_files.h"
#include "core/photo/decode.h"
#include "core/project/capture.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;

bool looks_like_a_photo(const fs::path& path) {
  const PhotoFormat formats[] = {PhotoFormat::jpeg,    PhotoFormat::png, PhotoFormat::tiff,
                                 PhotoFormat::openexr, PhotoFormat::raw, PhotoFormat::heif};
  return std::any_of(std::begin(formats), std::end(formats), [&](PhotoFormat format) {
    return is_usual_ending(format, path.extension().string());
  });
}

Paths photos_in(const fs::path& folder) {
  std::error_code failure;
  Paths photos;
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const bool hidden = entry.path().filename().string().rfind('.', 0) == 0;
    if (!hidden && entry.is_regular_file() && looks_like_a_photo(entry.path())) {
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

// Relative to the project, so that both move together.
fs::path from_project(const fs::path& path, const fs::path& project) {
  if (path.empty()) return path;
  const fs::path place = fs::weakly_canonical(fs::absolute(path));
  return place.lexically_relative(fs::weakly_canonical(fs::absolute(project)));
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
  if (wanted.cameras.empty()) {
    throw Error(
        "no cameras given; add --cameras with a COLMAP model, a transforms.json or a "
        ".cameramodel");
  }
  require_existence(wanted.cameras);
  require_folder(wanted.mattes, "mattes");
  require_folder(wanted.scribbles, "strokes");
}

struct KnownCameras {
  CameraFile file;
  bool completed = false;  // with sizes of photos, so that the file alone is not enough
};

KnownCameras known_cameras(const fs::path& path, const Progress& progress) {
  KnownCameras known;
  known.file = read_camera_file(path, [&](const fs::path& image) -> std::optional<glm::ivec2> {
    const DecodedPhoto photo = decode_photo(image, {}, progress);
    known.completed = true;
    return glm::ivec2(photo.width_px, photo.height_px);
  });
  return known;
}

Project planned_project(const NewProject& wanted, const CameraFile& cameras,
                        const Progress& progress) {
  const Paths photos = wanted.photos.empty() ? existing(cameras.images) : expanded(wanted.photos);
  if (photos.empty()) {
    throw Error("no photos given, and " + printable(wanted.cameras.string()) +
                " lists none that exist; name the photos or their folder");
  }
  const bool none_given = wanted.mattes.empty() && wanted.scribbles.empty();
  const fs::path mattes = none_given ? found_mattes(cameras, photos, progress) : wanted.mattes;

  Project project;
  project.folder = wanted.folder;
  for (const fs::path& photo : photos) project.photos.push_back(from_project(photo, wanted.folder));
  std::sort(project.photos.begin(), project.photos.end());
  project.cameras = from_project(wanted.cameras, wanted.folder);
  project.mattes = from_project(mattes, wanted.folder);
  project.scribbles = from_project(wanted.scribbles, wanted.folder);
  return project;
}

}  // namespace

Project make_project(const NewProject& wanted, const Recipe& recipe, bool replace,
                     const Progress& progress) {
  check_named(wanted, replace);
  const KnownCameras known = known_cameras(wanted.cameras, progress);
  Project project = planned_project(wanted, known.file, progress);
  project.recipe = recipe;
  if (project.recipe.pack.name.empty()) project.recipe.pack.name = project.name();
  gather_capture(project, known.file.cameras);

  std::error_code failure;
  fs::create_directories(wanted.folder, failure);
  if (failure) throw system_error(wanted.folder, "created", failure.value());
  if (known.completed) {
    project.cameras = "cameras.json";
    write_cameras(known.file.cameras, "transforms", project.absolute(project.cameras));
  }
  save_project(project);
  return project;
}

}  // namespace bosk
