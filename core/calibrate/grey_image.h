#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>

#include "core/image/image.h"

namespace bosk {

// Luma of 8 bits, as OpenCV's detectors take it. For the files of this folder alone.
cv::Mat grey_of(const Image<glm::vec3>& srgb);

}  // namespace bosk
