#pragma once

#include <optional>
#include <string>

#include "core/calibrate/solve_steps.h"
#include "core/calibrate/uncertainty.h"

namespace bosk {

// What the photos say against the lens, as a sentence with the remedy: EXIF that was far off, a
// focal length that they hardly determine, a known lens that another focal length would replace
// better. None: nothing.
std::optional<std::string> lens_doubt(const Solution& solution, const SolveQuestion& question,
                                      const BundleCovariance& covariance, const Progress& progress);

}  // namespace bosk
