#include "core/calibrate/ball_colour.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"

namespace bosk {

glm::vec3 saturation_from_lab(const glm::vec3& lab) {
  const float scale = 100.0f / std::max(lab.x + 16.0f, 40.0f);
  return {lab.y * scale, lab.z * scale, lab.x};
}

namespace {

constexpr int kBins = 64;          // along each axis
constexpr float kBinWidth = 7.0f;  // units of saturation

int bin_of(float saturation) {
  return std::clamp(int(std::floor(saturation / kBinWidth)) + kBins / 2, 0, kBins - 1);
}

Image<std::uint32_t> count_usage(const Image<glm::vec3>& saturation) {
  Image<std::uint32_t> usage(kBins, kBins);
  for (const glm::vec3& value : saturation.pixels()) ++usage(bin_of(value.x), bin_of(value.y));
  return usage;
}

}  // namespace

BallImage ball_image(const Image<glm::vec3>& srgb) {
  BallImage image;
  image.saturation = saturation_image(srgb);
  image.usage = count_usage(image.saturation);
  image.linear = Image<glm::vec3>(srgb.width(), srgb.height());
  tbb::parallel_for(0, srgb.height(), [&](int y) {
    for (int x = 0; x < srgb.width(); ++x) image.linear(x, y) = linear_from_srgb(srgb(x, y));
  });
  return image;
}

double common_pixels(const BallImage& image, const glm::vec2& saturation) {
  const int x = bin_of(saturation.x), y = bin_of(saturation.y);
  double sum = 0.0;
  for (int row = std::max(0, y - 2); row <= std::min(kBins - 1, y + 2); ++row)
    for (int column = std::max(0, x - 2); column <= std::min(kBins - 1, x + 2); ++column)
      sum += image.usage(column, row);
  return sum;
}

Image<glm::vec3> saturation_image(const Image<glm::vec3>& srgb) {
  Image<glm::vec3> saturation(srgb.width(), srgb.height());
  tbb::parallel_for(0, srgb.height(), [&](int y) {
    for (int x = 0; x < srgb.width(); ++x)
      saturation(x, y) = saturation_from_lab(lab_from_srgb(srgb(x, y)));
  });
  return saturation;
}

glm::vec3 sample_bilinear(const Image<glm::vec3>& image, const glm::dvec2& pixel) {
  const double x = std::clamp(pixel.x, 0.0, double(image.width() - 1));
  const double y = std::clamp(pixel.y, 0.0, double(image.height() - 1));
  const int left = int(x), top = int(y);
  const int right = std::min(left + 1, image.width() - 1);
  const int bottom = std::min(top + 1, image.height() - 1);
  const float u = float(x - left), v = float(y - top);
  return glm::mix(glm::mix(image(left, top), image(right, top), u),
                  glm::mix(image(left, bottom), image(right, bottom), u), v);
}

}  // namespace bosk
