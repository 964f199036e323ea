#include "ui/workstation/calibrate/known_cameras.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/photo/camera_files.h"
#include "core/photo/verdicts.h"
#include "ui/workstation/workspace.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

struct CamerasRead {
  std::vector<Camera> cameras;
  std::string trouble;
};

CamerasRead read_all(const fs::path& place, Progress& progress) {
  progress.begin("reading cameras", 1);
  try {
    CamerasRead read{read_cameras(place), {}};
    cameras_by_name(read.cameras);  // so that names are sure to be different
    return read;
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

void install(KnownToProject& known, const fs::path& place, CamerasRead read) {
  if (known.place != place) return;  // another file overtook it
  known.job = {};
  known.cameras = std::move(read.cameras);
  known.trouble = std::move(read.trouble);
  ++known.revision;
}

fs::file_time_type change_of(const fs::path& place) {
  std::error_code failure;
  const auto changed = fs::last_write_time(place, failure);
  return failure ? fs::file_time_type{} : changed;
}

std::set<std::string> names_of(const std::vector<Camera>& cameras) {
  std::set<std::string> names;
  for (const Camera& camera : cameras) names.insert(camera.name);
  return names;
}

// Nothing yet, in place of what was known.
KnownToProject begun_anew(const KnownToProject& known) {
  KnownToProject fresh;
  fresh.revision = known.revision + 1;
  return fresh;
}

// A project without a camera file has the cameras that were solved.
void follow_solved(KnownToProject& known, const SolvedCameras& solved) {
  if (known.place.empty() && known.solved == solved.revision) return;
  known = begun_anew(known);
  known.solved = solved.revision;
  if (solved.calibration) known.cameras = solved.calibration->cameras;
}

}  // namespace

void follow_cameras(Workspace& workspace) {
  KnownToProject& known = workspace.calibrate.known;
  const fs::path& named = workspace.project().cameras;
  if (named.empty()) return follow_solved(known, workspace.calibrate.solved);
  const fs::path place = workspace.project().absolute(named);
  const auto changed = change_of(place);
  if (was_stopped(known.job, workspace.jobs)) {
    known.trouble = "reading the cameras was stopped; import them again";
  }
  if (place == known.place && changed == known.changed) return;
  known = begun_anew(known);
  known.place = place;
  known.changed = changed;
  known.job.id = workspace.jobs.start(
      "Reading cameras", [place](Progress& progress) { return read_all(place, progress); },
      [&workspace, place](CamerasRead read) {
        install(workspace.calibrate.known, place, std::move(read));
      },
      Lane::interactive, "cameras");
}

const std::vector<Camera>& known_cameras_of(const Workspace& workspace) {
  return workspace.calibrate.known.cameras;
}

std::uint64_t known_cameras_revision(const Workspace& workspace) {
  return workspace.calibrate.known.revision;
}

std::vector<Camera> photo_cameras(const Workspace& workspace) {
  std::set<std::string> photos;
  for (const fs::path& photo : workspace.project().photos) photos.insert(photo.stem().string());
  std::vector<Camera> cameras = known_cameras_of(workspace);
  std::erase_if(cameras, [&](const Camera& camera) { return !photos.contains(camera.name); });
  return cameras;
}

std::vector<std::string> photos_without_camera(const Workspace& workspace) {
  const std::set<std::string> known = names_of(known_cameras_of(workspace));
  std::vector<std::string> names;
  for (const fs::path& photo : workspace.project().photos) {
    if (!known.contains(photo.stem().string())) names.push_back(photo.stem().string());
  }
  return names;
}

}  // namespace bosk
