#pragma once

#include <vector>

#include "core/calibrate/seed_solve.h"
#include "core/calibrate/solve_input.h"

namespace bosk {

// Where the solve begins: cameras and points in a frame and scale of their own.
struct SolveStart {
  BundleState state;
  std::vector<bool> ambiguous;  // of each camera: another solve that fits as well puts it elsewhere
  int seeds = 0;
};

// Tries all seeds on the points most often seen (thousands of features are too many), takes the one
// that costs least and adds the other points. Empty state: no seed led anywhere.
SolveStart start_solve(const SolveInput& input, std::span<const FirstPose> first_poses,
                       std::span<const PhotoSightings> photos, Progress& progress);

}  // namespace bosk
