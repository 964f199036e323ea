#include "core/billboard/volume_sampler.h"

#include <algorithm>
#include <cmath>

namespace bosk {

VolumeSampler::VolumeSampler(const RadianceVolume& volume)
    : volume_(volume), support_(volume.grid) {}

float VolumeSampler::extinction(const glm::vec3& at) const {
  const glm::vec3 base = glm::floor(at);
  const glm::ivec3 cell(base);
  const int side = volume_.grid.side();
  if (glm::any(glm::lessThan(cell, glm::ivec3(-1))) ||
      glm::any(glm::greaterThanEqual(cell, glm::ivec3(side)))) {
    return 0.0f;
  }
  const std::int32_t number = support_.find(cell);
  if (number < 0) return 0.0f;
  float weights[8];
  trilinear_weights(at - base, weights);
  float sum = 0.0f;
  const auto& corners = support_.corners(number);
  for (int i = 0; i < 8; ++i) {
    const auto corner = std::size_t(corners.number[i]);
    if (corner < volume_.extinction.size()) sum += weights[i] * volume_.extinction[corner];
  }
  return sum;
}

VolumeSampler::Value VolumeSampler::sample(const glm::vec3& at,
                                           const std::array<float, 9>& basis) const {
  const glm::vec3 base = glm::floor(at);
  const std::int32_t number = support_.find(glm::ivec3(base));
  Value value;
  if (number < 0) return value;
  float weights[8];
  trilinear_weights(at - base, weights);
  const auto& corners = support_.corners(number);
  const auto terms = std::size_t(volume_.coefficients());
  for (int i = 0; i < 8; ++i) {
    const auto corner = std::size_t(corners.number[i]);
    if (corner >= volume_.extinction.size()) continue;
    const float part = weights[i] * volume_.extinction[corner];
    value.extinction += part;
    const float* coefficients = &volume_.colour[corner * terms * 3];
    for (std::size_t j = 0; j < terms; ++j) {
      const float weight = part * basis[j];
      value.colour +=
          weight * glm::vec3(coefficients[3 * j], coefficients[3 * j + 1], coefficients[3 * j + 2]);
    }
  }
  if (value.extinction > 0.0f) value.colour /= value.extinction;
  return value;
}

glm::vec4 integrate(const VolumeSampler& sampler, const glm::vec3& origin,
                    const glm::vec3& direction, float from, float to,
                    const std::array<float, 9>& basis) {
  const int steps = std::max(1, int(std::lround(to - from)));
  const float step = (to - from) / float(steps);
  glm::vec3 colour(0.0f);
  float left = 1.0f;
  for (int s = 0; s < steps; ++s) {
    const glm::vec3 at = origin + direction * (from + (float(s) + 0.5f) * step);
    const VolumeSampler::Value value = sampler.sample(at, basis);
    const float kept = std::exp(-value.extinction * step);
    colour += glm::clamp(value.colour, 0.0f, 1.0f) * (left * (1.0f - kept));
    left *= kept;
  }
  return {colour, 1.0f - left};
}

}  // namespace bosk
