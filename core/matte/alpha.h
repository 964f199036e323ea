#pragma once

#include <string>

#include "core/matte/stroke_model.h"

namespace bosk {

struct AlphaEstimate {
  Image<float> alpha;
  Image<float> likelihood;  // natural logarithm; low where no pair of colours explains the pixel
};

struct AlphaSettings {
  std::string mixing = "curve";
  float position_sigma = 0.06f;  // fraction of the image diagonal
};

// Opacity of each pixel from its colour and its distance to the strokes. `tilt`, on a grid of any
// size that covers the image, says how much likelier opaque is than clear before the colour is
// looked at (natural logarithm); an empty image means even.
AlphaEstimate estimate_alpha(const LabPlanes& lab, const StrokeModel& model,
                             const Image<float>& tilt, const AlphaSettings& settings,
                             Progress& progress);

}  // namespace bosk
