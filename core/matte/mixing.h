#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/matte/stroke_model.h"

namespace bosk {

constexpr int kMixingSegments = 6;

// Colours that a leaf of one cluster shows in front of a background of another as its alpha grows
// from 0 to 1: a polyline in CIELab whose corners are about equally far apart.
struct MixingPath {
  std::array<glm::vec3, kMixingSegments + 1> corner{};
  std::array<float, kMixingSegments + 1> alpha{};  // at the corners
  float background_variance = 1.0f, foreground_variance = 1.0f;
  int foreground = 0, background = 0;  // clusters
};

// A pixel wholly of one cluster. Most are, so each cluster also speaks for itself, with the whole
// covariance of its colours.
struct PureColour {
  glm::vec3 lab{0.0f};
  std::array<float, 6> whitening{};  // lower triangle xx, yx yy, zx zy zz: makes the covariance 1
  float log_weight = 0.0f;           // of the prior, less the logarithm of the covariance's extent
  bool opaque = false;
  int cluster = 0;  // among those of its kind
};

// All ways to explain a pixel.
struct MixedColours {
  std::vector<MixingPath> paths;
  std::vector<PureColour> pure;
};

// One path per pair of clusters. `mixing` names the space in which the two mix: "curve" is linear
// light, which is right for raw sensors; cameras' tone curves bring photos nearer to "srgb" or
// "lab".
std::vector<MixingPath> mixing_paths(const StrokeModel& model, const std::string& mixing);

// One per cluster; `purity` is the natural logarithm of how much likelier it is than a mixture.
std::vector<PureColour> pure_colours(const StrokeModel& model, float purity);

}  // namespace bosk
