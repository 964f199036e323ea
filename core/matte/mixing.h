#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/matte/stroke_model.h"

namespace bosk {

constexpr int kMixingSegments = 6;

// Colours that a leaf of one cluster shows in front of a background of another as its alpha grows
// from 0 to 1: a polyline in CIELab whose corners are equally spaced in alpha.
struct MixingPath {
  std::array<glm::vec3, kMixingSegments + 1> corner;
  float background_variance = 1.0f, foreground_variance = 1.0f;
  int foreground = 0, background = 0;  // clusters
};

// One path per pair of clusters. `mixing` names the space in which light mixes: "curve" linear
// light seen in CIELab; "lab", "srgb": straight lines there; "linear" is like "curve" but measured
// in scaled linear light.
std::vector<MixingPath> mixing_paths(const StrokeModel& model, const std::string& mixing);

}  // namespace bosk
