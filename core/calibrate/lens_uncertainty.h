#pragma once

#include <Eigen/Dense>

#include "core/calibrate/lens_bundle.h"
#include "core/image/image.h"

// Private to this folder: the header shows Eigen.
namespace bosk {

// Covariance of a solved lens: rows and columns are its intrinsics and then, 3 numbers in the
// camera's frame, the mean turn of all boards. A lens that looks slightly elsewhere with all boards
// turned alike is the same lens: mrcal (doc/uncertainty.org, "mean-frames") takes that turn out,
// and so do we.
struct LensCovariance {
  LensFamily family = LensFamily::opencv4;
  std::vector<double> intrinsics;
  Eigen::MatrixXd covariance;
  glm::dvec2 warp_sigma_m{0.0};  // 0 where the warp wasn't freed

  double focal_sigma() const;  // relative
};

// Propagates corners' noise of `sigma_px` (for a weight of 1) through the solve:
//   H^-1 (J^T J) H^-1 sigma^2,   H = J^T J + mrcal's regularisation of the lens,
// J the derivative of all corners that count by lens, warp and poses. Each pose touches its own
// board alone, so poses are eliminated board by board.
LensCovariance lens_covariance(const LensState& state, const LensProblem& problem, bool warp,
                               double sigma_px);

// One sigma along an axis of where a point at infinity is seen, at the centres of columns x rows
// equal cells of the frame; at most 1000 px, which also stands where the lens sees nothing.
Image<float> projection_sigma(const LensCovariance& lens, int width_px, int height_px, int columns,
                              int rows);

}  // namespace bosk
