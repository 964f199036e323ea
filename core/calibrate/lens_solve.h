#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/options.h"
#include "core/base/progress.h"
#include "core/calibrate/boards.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/lens_profile.h"
#include "core/geometry/rigid_transform.h"

namespace bosk {

// A board as one photo shows it; corners as find_board gives them.
struct BoardView {
  std::string photo;
  int width_px = 0, height_px = 0;
  LensIdentity taken_with;
  std::vector<BoardCorner> corners;  // empty: no board was found
};

struct LensOptions {
  // "auto" takes the simplest whose error on boards that were held out is within noise of the best.
  std::string model = "auto";
  int folds = 5;           // of the cross-validation, 2 to 20
  bool board_warp = true;  // let the board bend a little, by the same shape in every photo
};
Options describe(LensOptions& options);

// What became of one photo.
struct BoardFinding {
  std::string photo;
  bool used = false;
  std::string reason;  // a clause that says why it was left out; empty for one that was used
  int corners = 0, outliers = 0;
  double rms_px =
      0.0;  // over both axes, outliers left out; where it was left out, as the lens sees it
  double tilt = 0.0;  // between the board's normal and the axis of the lens, radians
  RigidTransform camera_from_board;
};

struct CornerResidual {
  std::size_t board = 0;  // in LensCalibration::boards
  int column = 0, row = 0;
  glm::dvec2 pixel{0.0}, error_px{0.0};  // seen; predicted minus seen
  bool outlier = false;
};

// One lens model that was tried.
struct LensTrial {
  std::string model;             // "opencv4"
  double rms_px = 0.0;           // over the corners it was fitted to
  double held_out_rms_px = 0.0;  // over boards it wasn't; 0 without cross-validation
  bool chosen = false;
};

// `sentences` explain the verdict, most important first; each names what is wrong and what to do.
struct LensCalibration {
  Verdict verdict = Verdict::refused;
  std::vector<std::string> sentences;
  LensProfile profile;               // its lens is the best guess even where the verdict is refused
  std::vector<BoardFinding> boards;  // every view, in the order given
  std::vector<CornerResidual> residuals;  // of the boards used
  std::vector<LensTrial> trials;
  // Of the focal length, relative, one sigma: as noise lets expect, and as the lens moves with the
  // choice of boards (jackknife; far more where boards bend or the focus moved).
  double focal_sigma = 0.0, focal_spread = 0.0;
  glm::dvec2 board_warp_m{0.0};  // how far the board's middle stands out along x and y
  double corner_sigma_px = 0.0;  // noise of a corner along one axis, as the residuals show it
};

// The lens from photos of a board. Photos of another size or camera than most, and boards that
// disagree with the others (bent, moved, misread), are named and left out. Refused where what is
// left does not determine a lens: fewer than 3 boards, all of them seen from the front, residuals
// that no lens explains. The same to the bit at any number of threads.
//
// Throws Error when no view has a board at all; Cancelled.
LensCalibration calibrate_lens(std::span<const BoardView> views, const BoardShape& shape,
                               const LensOptions& options, Progress& progress);

}  // namespace bosk
