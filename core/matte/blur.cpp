#include "core/matte/blur.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bosk {
namespace {

std::vector<float> gaussian(float sigma) {
  std::vector<float> kernel{1.0f};
  for (int k = 1; k <= int(std::ceil(3.0f * sigma)); ++k) {
    kernel.push_back(std::exp(-0.5f * float(k * k) / (sigma * sigma)));
  }
  return kernel;
}

// Each row is the weighted mean of the rows around it; the loop along a row vectorises.
Image<float> blurred_vertically(const Image<float>& image, const std::vector<float>& kernel) {
  Image<float> result(image.width(), image.height());
  const int reach = int(kernel.size()) - 1;
  const auto width = std::size_t(image.width());
  tbb::parallel_for(0, image.height(), [&](int y) {
    float* target = result.data() + std::size_t(y) * width;
    float weights = 0.0f;
    for (int row = std::max(0, y - reach); row <= std::min(image.height() - 1, y + reach); ++row) {
      const float weight = kernel[std::size_t(std::abs(row - y))];
      const float* source = image.data() + std::size_t(row) * width;
      for (std::size_t x = 0; x < width; ++x) target[x] += weight * source[x];
      weights += weight;
    }
    for (std::size_t x = 0; x < width; ++x) target[x] /= weights;
  });
  return result;
}

Image<float> transposed(const Image<float>& image) {
  Image<float> result(image.height(), image.width());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) result(y, x) = image(x, y);
  }
  return result;
}

}  // namespace

Image<float> blurred(const Image<float>& image, float sigma) {
  if (sigma <= 0.0f) return image;
  const std::vector<float> kernel = gaussian(sigma);
  return transposed(blurred_vertically(transposed(blurred_vertically(image, kernel)), kernel));
}

}  // namespace bosk
