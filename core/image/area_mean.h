#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// The image at a smaller size, at least 1 x 1 and at most its own: each pixel is the mean over the
// area that it covers, edge pixels by their share. For values whose mean means something: opacity,
// linear light.
Image<float> area_mean(const Image<float>& values, int width, int height);
Image<glm::vec3> area_mean(const Image<glm::vec3>& linear, int width, int height);

// The same for an sRGB-encoded image: averaged in linear light.
Image<glm::vec3> area_mean_srgb(const Image<glm::vec3>& srgb, int width, int height);

// The same for sRGB-encoded colour with straight alpha: colours count by their alpha. For the
// screen: averaged as encoded.
Image<glm::vec4> area_mean_straight(const Image<glm::vec4>& straight, int width, int height);

}  // namespace bosk
