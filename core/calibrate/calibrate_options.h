#pragma once

#include <string>

#include "core/base/options.h"
#include "core/calibrate/balls.h"
#include "core/calibrate/boards.h"
#include "core/calibrate/features.h"
#include "core/calibrate/lens_solve.h"

namespace bosk {

// What to look for in the photos, and how to get from there to cameras.
struct CalibrateOptions {
  bool find_balls = true;
  BallOptions balls;
  std::string tags = "none";      // dictionary of the printed markers, or none
  double tag_side_m = 0.0;        // 0: not known, and tags give no scale
  std::string features = "auto";  // auto: where markers alone are too few; on, off
  double feature_megapixels = 1.5;
  FeatureOptions feature;
  std::string lens = "auto";  // auto: fixed where boards or a profile give it; free, known
  LensOptions board_lens;
  std::string board = "none";       // none, chessboard, charuco
  BoardShape shape;                 // but for its kind
  bool board_at_tree = false;       // it stands still among the photos of the tree
  double uncertain_crown_px = 0.6;  // one sigma above which a photo counts as uncertain
};
Options describe(CalibrateOptions& options);

// With its kind; throws Error when there is none or its numbers are no board's.
BoardShape board_of(const CalibrateOptions& options);

}  // namespace bosk
