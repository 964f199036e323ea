#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibrate/solve_steps.h"

namespace bosk {

// Fates and reasons of the photos that were solved: refused when their uncertainty at the crown is
// beyond use, uncertain when it is large, when another place of the camera fits as well, or when
// there are too few sightings to check each other.
void judge_photos(const Solution& solution, const SolveQuestion& question,
                  std::vector<PhotoFinding>& findings);

// Verdict and sentences of a calibration that is otherwise complete. `noise` is how much larger the
// sightings' errors are than they say.
void judge(const Solution& solution, const SolveQuestion& question, double noise,
           const std::optional<std::string>& doubt_of_lens, Calibration& calibration);

}  // namespace bosk
