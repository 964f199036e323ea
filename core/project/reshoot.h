#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/calibrate/calibration.h"

namespace bosk {

// Where another photo would help, on the ground as seen from above, and why.
struct ReshootPlace {
  glm::dvec2 in_world{0.0};  // x, y
  std::string why;           // a clause: "between IMG_07 and IMG_08: 41 degrees without a photo"
};

// Gaps of the walk that are much wider than its other steps, places of photos that were not placed
// (between their neighbours by name), and of those that are uncertain. None where fewer than two
// photos were placed. The trunk's foot is the world's origin.
std::vector<ReshootPlace> reshoot_places(const Calibration& calibration);

}  // namespace bosk
