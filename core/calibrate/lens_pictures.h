#pragma once

#include <glm/gtc/type_precision.hpp>

#include "core/calibrate/lens_solve.h"
#include "core/image/image.h"

namespace bosk {

// Pictures of a calibration for reports and panels, `width_px` wide and of the frame's shape,
// without text.

// Where corners lie: cells of the frame are the darker the fewer corners they have, red without
// any; a dot for each corner from green (no error) over yellow to red (three sigma and more,
// outliers).
Image<glm::u8vec3> coverage_picture(const LensCalibration& calibration, int width_px);

// The map of uncertainty from blue (0) over green and yellow to red (`full_px` and more), with
// contours at each quarter of `full_px`.
Image<glm::u8vec3> uncertainty_picture(const LensProfile& profile, int width_px,
                                       double full_px = 1.0);

}  // namespace bosk
