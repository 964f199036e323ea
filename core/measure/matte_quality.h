#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// How an alpha matte compares with the truth, in the measures of the alpha-matting benchmark
// (Rhemann et al. 2009), per megapixel so that sizes compare.
struct MatteScore {
  double sad = 0.0;         // sum of |alpha - truth| / 1000 per megapixel
  double mse = 0.0;         // mean squared error x 1000
  double grad = 0.0;        // squared difference of gradients (sigma 1.4) / 1000 per megapixel
  double bias = 0.0;        // mean of alpha - truth: positive where the matte is too full
  double foreground = 0.0;  // RMS error of the straight colour weighted by true alpha, 0 to 255
};

// Straight sRGB-encoded colour and alpha, 0 to 1, of the same size; without colours `foreground`
// means nothing. Error when the sizes differ or there are no pixels.
MatteScore score_matte(const Image<glm::dvec4>& matte, const Image<glm::dvec4>& truth);

struct MatteScoreField {
  const char* name;
  double MatteScore::*value;
};
inline constexpr std::array<MatteScoreField, 5> kMatteScoreFields{
    {{"sad", &MatteScore::sad},
     {"mse", &MatteScore::mse},
     {"grad", &MatteScore::grad},
     {"bias", &MatteScore::bias},
     {"fg", &MatteScore::foreground}}};

}  // namespace bosk
