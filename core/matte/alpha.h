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
  float position_sigma = 0.1f;  // reach of a stroke's colours, as a fraction of the image diagonal
  float purity = 1.0f;  // how much likelier one pure colour is than a mixture (natural logarithm)
};

// Opacity of each pixel from its colour and its distance to the strokes. `tilt`, on a grid of any
// size over the image, says how much likelier opaque is than clear before the colour is looked at
// (natural logarithm). Calls progress.advance() for each row.
AlphaEstimate estimate_alpha(const LabPlanes& lab, const StrokeModel& model,
                             const Image<float>& tilt, const AlphaSettings& settings,
                             Progress& progress);

}  // namespace bosk
