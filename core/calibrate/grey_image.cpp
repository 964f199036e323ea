#include "core/calibrate/grey_image.h"

#include <algorithm>
#include <cstdint>

namespace bosk {

cv::Mat grey_of(const Image<glm::vec3>& srgb) {
  cv::Mat grey(srgb.height(), srgb.width(), CV_8U);
  for (int y = 0; y < srgb.height(); ++y)
    for (int x = 0; x < srgb.width(); ++x) {
      const float luma = glm::dot(srgb(x, y), glm::vec3(0.299f, 0.587f, 0.114f));
      grey.at<std::uint8_t>(y, x) = std::uint8_t(std::clamp(luma, 0.0f, 1.0f) * 255.0f + 0.5f);
    }
  return grey;
}

}  // namespace bosk
