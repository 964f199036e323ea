#pragma once

#include <optional>
#include <string>

#include "core/calibrate/solve_steps.h"
#include "core/calibrate/uncertainty.h"

namespace bosk {

// Why solving isn't worth beginning; none: it is.
std::optional<std::string> too_little(const SolveInput& input, const SolveQuestion& question);

// A verdict without cameras: `sentences`, and what is known of each photo.
Calibration refused_calibration(const SolveInput& input, const SolveQuestion& question,
                                std::vector<std::string> sentences);

// All that a finished solve says, with the verdict. Throws Cancelled.
Calibration report(const Solution& solution, const SolveQuestion& question,
                   const Progress& progress);

}  // namespace bosk
