#include "core/image/colour.h"

#include <cmath>

namespace bosk {
namespace {

// sRGB primaries and D65 white, IEC 61966-2-1; glm matrices are written column by column.
const glm::mat3 kXyzFromLinear(0.4124564f, 0.2126729f, 0.0193339f,  //
                               0.3575761f, 0.7151522f, 0.1191920f,  //
                               0.1804375f, 0.0721750f, 0.9503041f);
const glm::mat3 kLinearFromXyz = glm::inverse(kXyzFromLinear);
const glm::vec3 kWhite = kXyzFromLinear * glm::vec3(1.0f);
constexpr float kDelta = 6.0f / 29.0f;

float lab_curve(float ratio) {
  if (ratio > kDelta * kDelta * kDelta) return std::cbrt(ratio);
  return ratio / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

float inverse_lab_curve(float value) {
  if (value > kDelta) return value * value * value;
  return 3.0f * kDelta * kDelta * (value - 4.0f / 29.0f);
}

}  // namespace

float linear_from_srgb(float encoded) {
  const float size = std::abs(encoded);
  const float linear = size <= 0.04045f ? size / 12.92f : std::pow((size + 0.055f) / 1.055f, 2.4f);
  return std::copysign(linear, encoded);
}

float srgb_from_linear(float linear) {
  const float size = std::abs(linear);
  const float encoded =
      size <= 0.0031308f ? size * 12.92f : 1.055f * std::pow(size, 1.0f / 2.4f) - 0.055f;
  return std::copysign(encoded, linear);
}

glm::vec3 linear_from_srgb(const glm::vec3& encoded) {
  return {linear_from_srgb(encoded.x), linear_from_srgb(encoded.y), linear_from_srgb(encoded.z)};
}

glm::vec3 srgb_from_linear(const glm::vec3& linear) {
  return {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
}

glm::vec3 lab_from_linear(const glm::vec3& linear_rgb) {
  const glm::vec3 ratio = kXyzFromLinear * linear_rgb / kWhite;
  const float x = lab_curve(ratio.x), y = lab_curve(ratio.y), z = lab_curve(ratio.z);
  return {116.0f * y - 16.0f, 500.0f * (x - y), 200.0f * (y - z)};
}

glm::vec3 linear_from_lab(const glm::vec3& lab) {
  const float y = (lab.x + 16.0f) / 116.0f;
  const glm::vec3 ratio(inverse_lab_curve(y + lab.y / 500.0f), inverse_lab_curve(y),
                        inverse_lab_curve(y - lab.z / 200.0f));
  return kLinearFromXyz * (ratio * kWhite);
}

}  // namespace bosk
