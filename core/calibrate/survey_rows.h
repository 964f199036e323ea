#pragma once

#include <span>

#include "core/calibrate/solve_input.h"

namespace bosk {

// Throws Error for sigmas or lengths that aren't above 0 and numbers that aren't finite.
void check_survey(const Survey& survey);

// Adds a row for all that was measured between points that are seen, and a sentence for what names
// points that aren't. A point named "X foot" is the lower end of the upright stick of X.
void add_survey(const Survey& survey, std::span<const PhotoSightings> photos, SolveInput& input);

}  // namespace bosk
