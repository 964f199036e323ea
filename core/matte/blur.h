#pragma once

#include "core/image/image.h"

namespace bosk {

// Gaussian average with standard deviation `sigma` pixels; beyond the border the image is repeated
// by weighting only what lies inside.
Image<float> blurred(const Image<float>& image, float sigma);

}  // namespace bosk
