#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>

#include "core/image/image.h"

namespace bosk {

// The square of `side` (odd) pixels around the one that `at_px` lies in; clear beyond the picture.
Image<glm::u8vec4> loupe_of(const Image<glm::u8vec4>& picture, const glm::dvec2& at_px, int side);

}  // namespace bosk
