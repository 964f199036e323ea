#pragma once

#include "core/base/progress.h"
#include "core/image/image.h"

namespace bosk {

// The tree's own colour behind each pixel, free of the background that shines through: linear
// light, in the photo's range. Where alpha is 0 it continues the nearest foreground. Progress
// counts `height` rows.
Image<glm::vec3> estimate_foreground(const Image<glm::vec3>& linear, const Image<float>& alpha,
                                     Progress& progress);

}  // namespace bosk
