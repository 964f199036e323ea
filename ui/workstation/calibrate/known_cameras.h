#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/photo/camera.h"
#include "ui/workstation/watched_job.h"

namespace bosk {

struct Workspace;

// The project's cameras as its file says, also while too few of the photos fit them for a run;
// without a file those of its newest calibration.
struct KnownToProject {
  std::filesystem::path place;  // that was read; empty: none
  std::uint64_t solved = 0;     // revision of the calibration that they are from; 0: of none
  std::filesystem::file_time_type changed{};
  std::vector<Camera> cameras;
  std::string trouble;  // why there are none
  std::uint64_t revision = 1;
  WatchedJob job;
};

// Reads the file where it is another, or has changed. Once a frame by steps that show cameras.
void follow_cameras(Workspace& workspace);

const std::vector<Camera>& known_cameras_of(const Workspace& workspace);
std::uint64_t known_cameras_revision(const Workspace& workspace);
// Those of photos that the project has, in the file's order.
std::vector<Camera> photo_cameras(const Workspace& workspace);
// Names of photos without a camera, in the project's order.
std::vector<std::string> photos_without_camera(const Workspace& workspace);

}  // namespace bosk
