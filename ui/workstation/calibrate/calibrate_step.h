#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/workstation/calibrate/frusta.h"
#include "ui/workstation/calibrate/known_cameras.h"
#include "ui/workstation/calibrate/photo_canvas.h"
#include "ui/workstation/calibrate/photo_differences.h"
#include "ui/workstation/calibrate/solved_cameras.h"
#include "ui/workstation/notice.h"
#include "ui/workstation/watched_job.h"

namespace bosk {

struct Workspace;

// What is shown large of a project whose cameras are found and solved.
enum class CalibrateView { photo, cameras, wheel, lens };

// A field whose number is being typed; empty: none.
struct NumberInHand {
  std::string name;
  double value = 0.0;
};

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
  bool view_of_solved = false;      // and whether those were solved
  PhotoDifferences differences;

  // Of a project without a camera file:
  SolvedCameras solved;
  CalibrateView shown = CalibrateView::photo;
  PhotoCanvas canvas;
  std::string shown_in_list;         // the chosen point that the list last scrolled to
  std::string new_point, rename_to;  // as typed
  std::string typed_profile, typed_boards, typed_profile_place;  // where they are
  std::string pointed_at;        // name of the photo that the mouse is on
  std::vector<PointRow> points;  // as of the revisions below
  std::uint64_t points_session = 0, points_solved = 0;
  Tape new_tape;  // to be added
  Height new_height;
  SurveyedPoint new_surveyed;
  NumberInHand number_in_hand;
};

void draw_calibrate_step(Workspace& workspace);

}  // namespace bosk
