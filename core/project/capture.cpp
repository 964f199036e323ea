#include "core/project/capture.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/photo/camera_files.h"
#include "core/project/calibration_run.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

// The cameras of a project without a camera file, and why other photos have none.
Calibration project_calibration(const Project& project) {
  const std::string folder = printable(project.folder.string());
  const auto stored =
      stored_calibration(gather_calibration(project), Cache(project.cache_folder()));
  if (!stored) {
    throw Error(folder + ": the project has no cameras yet; " + cameras_remedy(project.folder));
  }
  if (stored->verdict != Verdict::refused) return *stored;
  throw Error(folder + ": " + refusal_of(*stored) + "; `bosk calibrate " + folder + "` tells more");
}

FilesByName files_of_folder(const Project& project, const fs::path& folder) {
  return folder.empty() ? FilesByName{} : files_in(project.absolute(folder));
}

struct Candidates {
  FilesByName photos, mattes, scribbles;
  std::map<std::string, Camera> cameras;
  std::map<std::string, std::string> refusals;  // why calibration gave a photo no camera
};

Candidates find_candidates(const Project& project, const std::vector<Camera>& cameras) {
  Candidates found;
  found.photos = photo_files(project);
  for (const Camera& camera : cameras) found.cameras[camera.name] = camera;
  found.mattes = files_of_folder(project, project.mattes);
  found.scribbles = files_of_folder(project, project.scribbles);
  return found;
}

// Why the photo can't be used; none when it can.
std::optional<std::string> obstacle(const Candidates& found, bool needs_matte,
                                    const std::string& name) {
  const auto refusal = found.refusals.find(name);
  if (refusal != found.refusals.end()) return refusal->second;
  if (found.cameras.count(name) == 0) return "the camera file has no camera of that name";
  if (needs_matte && found.mattes.count(name) == 0) return "there is no matte of that name";
  return std::nullopt;
}

void require_two_photos(const Project& project, const Capture& capture) {
  if (capture.photos.size() >= 2) return;
  std::string message = printable(project.folder.string()) +
                        ": at least 2 usable photos are needed, " +
                        std::to_string(capture.photos.size()) + " of " +
                        std::to_string(project.photos.size()) + " can be used";
  if (!capture.remarks.empty()) message += "; " + capture.remarks.front();
  throw Error(message);
}

void remark_on_strokes(const Project& project, const Candidates& found, Capture& capture) {
  for (const auto& [name, strokes] : project.strokes) {
    if (found.photos.count(name) == 0) {
      capture.remarks.push_back("strokes on " + printable(name) +
                                " are not used: the project has no photo of that name");
    }
  }
}

Capture gathered(const Project& project, const Candidates& found) {
  const bool needs_matte = !project.mattes.empty();
  Capture capture;
  for (const auto& [name, path] : found.photos) {
    if (const auto reason = obstacle(found, needs_matte, name)) {
      capture.remarks.push_back("photo " + printable(name) + " is not used: " + *reason);
      continue;
    }
    capture.photos.push_back({name, path, {}});
    capture.cameras.push_back(found.cameras.at(name));
    if (needs_matte) capture.mattes.push_back({name, found.mattes.at(name), {}});
    const auto strokes = found.scribbles.find(name);
    if (strokes != found.scribbles.end()) capture.scribbles.push_back({name, strokes->second, {}});
  }
  take_strokes(capture, project.strokes);
  remark_on_strokes(project, found, capture);
  require_two_photos(project, capture);
  hash_content(capture.photos);
  hash_content(capture.mattes);
  hash_content(capture.scribbles);
  return capture;
}

}  // namespace

Capture gather_capture(const Project& project) {
  if (!project.cameras.empty()) {
    return gather_capture(project, read_cameras(project.absolute(project.cameras)));
  }
  return gather_capture(project, project_calibration(project));
}

Capture gather_capture(const Project& project, const std::vector<Camera>& cameras) {
  return gathered(project, find_candidates(project, cameras));
}

Capture gather_capture(const Project& project, const Calibration& calibration) {
  Candidates found = find_candidates(project, calibration.cameras);
  for (const PhotoFinding& photo : calibration.photos) {
    if (photo.fate == PhotoFate::refused) found.refusals[photo.photo] = photo.reason;
  }
  return gathered(project, found);
}

void take_strokes(Capture& capture, const Strokes& strokes) {
  capture.strokes.clear();
  for (const SourceFile& photo : capture.photos) {
    const auto drawn = strokes.find(photo.name);
    if (drawn != strokes.end() && !drawn->second.empty()) capture.strokes.insert(*drawn);
  }
}

std::string cameras_remedy(const fs::path& project_folder) {
  const std::string folder = printable(project_folder.string());
  return "find them with `bosk calibrate " + folder + "`, or give some with `bosk new --replace " +
         folder + " --cameras FILE`, or in the Calibrate step of `bosk open " + folder + "`";
}

std::vector<std::string> photo_names(const Project& project) {
  std::vector<std::string> names;
  for (const auto& [name, path] : photo_files(project)) names.push_back(name);
  return names;
}

void hash_camera(ContentHasher& hasher, const Camera& camera) {
  const Lens& lens = camera.lens;
  hasher.text(camera.name).value(int(lens.model)).value(lens.width_px).value(lens.height_px);
  for (int i = 0; i < 2; ++i) hasher.value(lens.focal_px[i]).value(lens.principal_px[i]);
  for (const double coefficient : lens.distortion) hasher.value(coefficient);
  for (int i = 0; i < 3; ++i) {
    hasher.value(camera.camera_from_world.translation[i]);
    for (int k = 0; k < 3; ++k) hasher.value(camera.camera_from_world.rotation[i][k]);
  }
}

}  // namespace bosk
