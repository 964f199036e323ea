#include "core/project/camera_choice.h"

#include <optional>
#include <set>

#include "core/base/content_hash.h"
#include "core/photo/decode.h"
#include "core/project/capture.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;

// The picture that a camera file lists or, where it is missing, the photo of its name. Where that
// is missing too, the former, so that an error names it.
fs::path picture_for(const fs::path& image, const Paths& photos) {
  std::error_code none;
  if (fs::exists(image, none)) return image;
  for (const fs::path& photo : photos) {
    if (photo.stem() == image.stem() && fs::exists(photo, none)) return photo;
  }
  return image;
}

}  // namespace

KnownCameras known_cameras(const fs::path& file_or_folder, const Paths& photos,
                           const Progress& progress) {
  KnownCameras known;
  const auto size_of = [&](const fs::path& image) -> std::optional<glm::ivec2> {
    const DecodedPhoto photo = decode_photo(picture_for(image, photos), {}, progress);
    known.completed = true;
    return glm::ivec2(photo.width_px, photo.height_px);
  };
  known.file = read_camera_file(file_or_folder, size_of);
  return known;
}

CameraChoice match_cameras(const Project& project, const fs::path& file_or_folder,
                           const Progress& progress) {
  CameraChoice choice;
  choice.chosen = file_or_folder;
  Paths photos;
  for (const fs::path& photo : project.photos) photos.push_back(project.absolute(photo));
  choice.known = known_cameras(file_or_folder, photos, progress);
  std::set<std::string> with_camera;
  for (const Camera& camera : choice.known.file.cameras) with_camera.insert(camera.name);
  for (const std::string& name : photo_names(project)) {
    if (with_camera.count(name) == 0) choice.unmatched.push_back(name);
  }
  choice.matched = project.photos.size() - choice.unmatched.size();
  return choice;
}

fs::path project_path(const CameraChoice& choice, const Project& project) {
  if (!choice.known.completed) return project.relative(choice.chosen);
  ContentHasher hasher;
  for (const Camera& camera : choice.known.file.cameras) hash_camera(hasher, camera);
  const fs::path stored = "cameras-" + hex(hasher.finish()).substr(0, 8) + ".json";
  write_cameras(choice.known.file.cameras, "transforms", project.absolute(stored));
  return stored;
}

}  // namespace bosk
