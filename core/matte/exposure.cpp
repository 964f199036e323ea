#include "core/matte/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr std::array kQuantiles{0.5, 0.7, 0.9};
constexpr std::size_t kSamples = 40000;
constexpr float kDarkest = 1e-3f;  // linear; below, noise and black borders decide

std::array<float, kQuantiles.size()> quantiles(const Image<glm::vec3>& srgb, int channel) {
  std::vector<float> values;
  const std::size_t step = std::max<std::size_t>(1, srgb.size() / kSamples);
  for (std::size_t i = 0; i < srgb.size(); i += step) values.push_back(srgb.data()[i][channel]);
  std::sort(values.begin(), values.end());
  std::array<float, kQuantiles.size()> result{};
  for (std::size_t q = 0; q < kQuantiles.size(); ++q) {
    result[q] = linear_from_srgb(values[std::size_t(kQuantiles[q] * double(values.size() - 1))]);
  }
  return result;
}

}  // namespace

glm::vec3 exposure_gain(const Image<glm::vec3>& srgb, const Image<glm::vec3>& like_srgb) {
  glm::vec3 gain(1.0f);
  if (srgb.empty() || like_srgb.empty()) return gain;
  for (int channel = 0; channel < 3; ++channel) {
    const auto own = quantiles(srgb, channel), wanted = quantiles(like_srgb, channel);
    float log_sum = 0.0f;
    for (std::size_t q = 0; q < own.size(); ++q) {
      log_sum += std::log(std::max(wanted[q], kDarkest) / std::max(own[q], kDarkest));
    }
    gain[channel] = std::exp(log_sum / float(own.size()));
  }
  return gain;
}

}  // namespace bosk
