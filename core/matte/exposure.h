#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// Gain per channel, in linear light, that brings a photo nearest to another one's exposure and
// white balance: the 50, 70 and 90 % quantiles of each channel are matched.
glm::vec3 exposure_gain(const Image<glm::vec3>& srgb, const Image<glm::vec3>& like_srgb);

}  // namespace bosk
