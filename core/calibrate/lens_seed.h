#pragma once

#include <optional>

#include "core/calibrate/lens_bundle.h"

namespace bosk {

// A first lens without distortion (family opencv4, all terms 0) and first board poses: focal
// lengths by Zhang's constraints (cv::initCameraMatrix2D) and 0.6 to 4 times the longer side are
// tried with planar pose estimation (cv::solvePnP, IPPE) of every board; the one whose median
// corner error is smallest wins. None when no board gives a pose.
std::optional<LensState> lens_seed(const LensProblem& problem);

// The board's pose under the state's lens, from its corners that count; none for fewer than 6.
std::optional<mrcal_pose_t> board_pose_seen(const LensState& state, const LensProblem& problem,
                                            std::size_t board);

}  // namespace bosk
