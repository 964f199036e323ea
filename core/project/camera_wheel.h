#pragma once

#include <string>

#include "core/calibrate/calibration.h"

namespace bosk {

// The walk as seen from above, as an SVG element: cameras with their lines of sight and error
// ellipses, markers, the trunk, and where to re-shoot. Ellipses are enlarged alike, by a factor
// that the picture says.
std::string camera_wheel_svg(const Calibration& calibration);

}  // namespace bosk
