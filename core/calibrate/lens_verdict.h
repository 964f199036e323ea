#pragma once

#include "core/calibrate/lens_solve.h"

namespace bosk {

// Sets verdict and sentences from all that else is in the calibration.
void judge_lens(LensCalibration& calibration, const BoardShape& shape);

}  // namespace bosk
