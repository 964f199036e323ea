#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/package/tree_model.h"
#include "core/photo/camera.h"

namespace bosk {

struct LevelSwitchOptions {
  double least_psnr_db = 31.0;  // a level serves while it is this near to the finest one ...
  double slack_db = 1.0;  // ... or at most this much farther from the truth than the best level
  int most_cameras = 2;   // spread over the list that is given
};

// How far the tree, drawn at one level alone, is from the finest level drawn larger and box-reduced
// to the same size: over white, sRGB-encoded, in the pixels that either touches, all cameras
// together.
struct LevelError {
  std::size_t level_slot = 0;
  int tree_px = 0;       // size on screen of the tree's cube
  double cell_px = 0.0;  // and of a cell of that level
  double psnr_db = 0.0;  // 99 where the two are equal
};

// Levels at sizes of the tree's cube from 2 px in steps of two, where their cells are at least 1/8
// px: finer ones cost the most time and show no more. Cameras give
// the directions; one farther in than 1.5 sides of the cube is moved out to there. Without cameras:
// one from the side. Empty for a tree without levels.
std::vector<LevelError> measure_level_errors(const TreeModel& model,
                                             const std::vector<Camera>& cameras,
                                             const LevelSwitchOptions& options, Progress& progress);

// Sets max_cell_px of every level but the finest to the largest size at which it is good enough,
// interpolated between measured ones; 0 where it never is, but at least a pixel for the root. The
// finest has no limit: 0.
void set_level_switches(TreeModel& model, const std::vector<Camera>& cameras, Progress& progress,
                        const LevelSwitchOptions& options = {});

}  // namespace bosk
