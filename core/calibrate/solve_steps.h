#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibrate/solve_input.h"
#include "core/calibrate/solve_start.h"
#include "core/calibrate/world.h"

namespace bosk {

// A solve as it goes: input, what it has come to, and how far sightings may be off.
struct Solution {
  SolveInput input;
  BundleState state;
  Determined determined;
  std::vector<bool> ambiguous;  // of each photo as given
  double loss = kFinalLoss;     // sigmas beyond which a sighting is a mistake
};

// What solve_cameras was given.
struct SolveQuestion {
  std::span<const PhotoSightings> photos;
  const Survey& survey;
  const LensKnowledge& lens;
  const SolveOptions& options;
};

// Sigmas of each sighting, radial; infinite behind the camera.
std::vector<double> sighting_sigmas(const Solution& solution);

// Robust solve of all points, with a loss that widens when sightings are worse than they say.
void settle(Solution& solution, const Progress& progress);

// Names the photos of which fewer than half of the sightings, or too few, fit, and solves without
// them, until none is left. False when most photos don't fit each other.
bool leave_out_photos(Solution& solution, const SolveQuestion& question, Progress& progress);

// Puts the world where the survey wants it and solves all together; then drops what is beyond the
// loss and solves by plain least squares. False when too few photos are left to go on.
bool finish(Solution& solution, const SolveQuestion& question, Progress& progress);

}  // namespace bosk
