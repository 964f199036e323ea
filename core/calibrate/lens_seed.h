#pragma once

#include <optional>
#include <vector>

#include "core/calibrate/lens_bundle.h"

namespace bosk {

// A first lens without distortion (family opencv4, all terms 0) and first board poses: focal
// lengths by Zhang's constraints (cv::initCameraMatrix2D) and 0.6 to 4 times the longer side are
// tried with planar pose estimation (cv::solvePnP, IPPE) of every board; the one whose median
// corner error is smallest wins. None when no board gives a pose.
std::optional<LensState> lens_seed(const LensProblem& problem);

// A board alone under a lens.
struct PlacedBoard {
  mrcal_pose_t camera_from_board{};
  LensProblem problem;             // it alone; corners that are far off besides marked as outliers
  std::vector<glm::dvec2> errors;  // of its corners

  double three_quarters_px()
      const;  // what three quarters of its corners that count miss by at most
};

// The board's pose under the state's lens and warp, from its corners that count; those that miss by
// over six times the median, and by over `gross_px`, are marked and the others placed again. None
// for fewer than 6 corners.
std::optional<PlacedBoard> placed_board(const LensState& state, const LensProblem& problem,
                                        std::size_t board, double gross_px);

// The value that a share of the values, 0 to 1, does not exceed. At least one value.
double quantile(std::vector<double> values, double share);

}  // namespace bosk
