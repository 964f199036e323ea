#pragma once

#include <string>

#include "ui/workstation/calibrate/frusta.h"
#include "ui/workstation/calibrate/known_cameras.h"
#include "ui/workstation/calibrate/photo_differences.h"
#include "ui/workstation/notice.h"
#include "ui/workstation/watched_job.h"

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct CalibrateStepState {
  KnownToProject known;
  Notices said;
  std::string typed;     // where cameras are
  WatchedJob import;     // of cameras
  std::string selected;  // a photo's name
  std::string through;   // the camera that one looks through; empty: from outside
  OrbitView view;
  std::uint64_t view_revision = 0;  // of the cameras that `view` was laid out for
  PhotoDifferences differences;
};

void draw_calibrate_step(Workspace& workspace);

}  // namespace bosk
