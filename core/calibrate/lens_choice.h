#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/lens_bundle.h"

namespace bosk {

// A lens of one family, solved over all boards.
struct LensCandidate {
  LensState state;
  std::vector<double> held_out;   // mean squared weighted error of each board when it was held out
  std::vector<double> focals_px;  // of the lens without each fold
};

// K-fold cross-validation over boards: each fold is left out of a solve (outliers stay as marked),
// then its boards are placed under that lens, which stays fixed, and their corner errors taken.
// Fewer boards than `folds`: one board a fold. `warp`: whether solves free the board's warp.
void cross_validate(LensCandidate& candidate, const LensProblem& problem, int folds, bool warp,
                    Progress& progress);

// Of candidates from simple to rich the first whose mean held-out error exceeds the best one's by
// no more than the standard error of their difference over boards, or 1 %; and, where one of those
// sees the whole frame, the first that does (a polynomial may fold over beyond the outermost
// corner).
std::size_t simplest_within_noise(const std::vector<LensCandidate>& candidates, int width_px,
                                  int height_px);

double held_out_rms(const LensCandidate& candidate);

// How far the focal length moves with the choice of boards, relative, one sigma: the jackknife over
// folds (Efron and Tibshirani 1993, chapter 11). Boards that are bent or misread move it by more
// than noise would; its own error is about a third with 5 folds. 0 without folds.
double jackknife_focal_sigma(const LensCandidate& candidate);

}  // namespace bosk
