#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace bosk {

// A circle through points of which some don't belong to it.
struct CircleFit {
  glm::dvec2 centre{0.0};
  double radius = 0.0;
  double rms = 0.0;           // of the points that belong, from the circle
  double centre_sigma = 0.0;  // along each axis, for points of sigma 1 px
  std::vector<bool> belongs;  // beside the points
  int inliers = 0;
};

// The circle that most points agree with within `tolerance`, of a radius in [least, most]; the
// points run round its edge. Every triple of a fixed pattern is tried, then the distances from the
// circle are made least (geometric fit, Gauss-Newton). None when fewer than 5 agree.
std::optional<CircleFit> fit_circle(std::span<const glm::dvec2> edge, double least, double most,
                                    double tolerance);

}  // namespace bosk
