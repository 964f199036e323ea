#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"

namespace bosk {

// The lower end of a ball's stick, where it meets the ground.
struct StickFoot {
  glm::dvec2 pixel{0.0};
  double sigma_px = 1.0;
};

// A coloured ball on a stick, as one photo shows it.
struct SightedBall {
  glm::dvec2 centre_px{0.0};  // of the whole disc, also where a part is hidden
  double radius_px = 0.0;
  double sigma_px = 0.5;       // of the centre, along each axis
  double visible = 1.0;        // share of the disc that shows
  glm::vec2 saturation{0.0f};  // 100 (a*, b*) / (L* + 16): one for a colour in sun and shade
  float lightness = 50.0f;     // median L* of what shows
  double contrast = 0.0;       // of its saturation against that of what surrounds it
  std::optional<StickFoot> foot;
};

struct BallOptions {
  double smallest_diameter_px = 6.0;  // 4 to 100
  double largest_diameter_px = 200.0;
  double least_visible = 0.4;  // share of the disc, 0 to 1: what shows less is left out
};

// The balls of one photo (sRGB, 0 to 1), from left to right. Any saturated colour that stands off
// from what surrounds it will do. What is doubtful is left out. Throws Cancelled.
std::vector<SightedBall> find_balls(const Image<glm::vec3>& srgb, const BallOptions& options,
                                    const Progress& progress);

}  // namespace bosk
