#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/image/colour.h"
#include "core/photo/decode.h"

namespace bosk {

// Reads the pixels of a DecodedPhoto one by one, whatever their type: a whole photo as floats would
// take 16 bytes a pixel. T is uint8_t or uint16_t (sRGB-encoded) or float (linear light); known
// channels halve the time that a resampling takes.
template <class T, int channels>
class PixelSource {
 public:
  explicit PixelSource(const DecodedPhoto& photo)
      : bytes_(photo.pixels.data()), width_(photo.width_px) {
    if constexpr (!kFloat) {
      linear_.resize(std::size_t(kTop) + 1);
      for (std::size_t i = 0; i < linear_.size(); ++i) {
        linear_[i] = linear_from_srgb(float(i) / float(kTop));
      }
    }
  }

  // Linear light and straight alpha, as a pixel's mean needs it.
  glm::vec4 straight_linear(int x, int y) const {
    const auto values = at(x, y);
    return {linear(values[0]), linear(values[1]), linear(values[2]), unit(values[3])};
  }
  // sRGB-encoded, 0 to 1, and straight alpha.
  glm::vec4 straight_srgb(int x, int y) const {
    const auto values = at(x, y);
    return {encoded(values[0]), encoded(values[1]), encoded(values[2]), unit(values[3])};
  }

 private:
  static constexpr bool kFloat = std::is_floating_point_v<T>;
  static constexpr T kTop = kFloat ? T(1) : std::numeric_limits<T>::max();

  std::array<T, 4> at(int x, int y) const {
    std::array<T, 4> stored{};
    const std::size_t pixel = std::size_t(y) * std::size_t(width_) + std::size_t(x);
    constexpr std::size_t kSize = sizeof(T) * std::size_t(channels);
    std::memcpy(stored.data(), bytes_ + pixel * kSize, kSize);
    if constexpr (channels == 3) return {stored[0], stored[1], stored[2], kTop};
    if constexpr (channels == 4) return stored;
    return {stored[0], stored[0], stored[0], channels == 2 ? stored[1] : kTop};
  }
  float linear(T value) const {
    if constexpr (kFloat)
      return std::max(value, 0.0f);
    else
      return linear_[value];
  }
  static float unit(T value) { return std::clamp(float(value) / float(kTop), 0.0f, 1.0f); }
  static float encoded(T value) {
    if constexpr (kFloat)
      return std::min(srgb_from_linear(std::max(value, 0.0f)), 1.0f);
    else
      return unit(value);
  }

  const std::byte* bytes_;
  int width_;
  std::vector<float> linear_;
};

template <class T, class Use>
decltype(auto) visit_channels(const DecodedPhoto& photo, Use use) {
  if (photo.channels == 1) return use(PixelSource<T, 1>(photo));
  if (photo.channels == 2) return use(PixelSource<T, 2>(photo));
  if (photo.channels == 3) return use(PixelSource<T, 3>(photo));
  return use(PixelSource<T, 4>(photo));
}

// Calls `use` with the PixelSource that fits the photo.
template <class Use>
decltype(auto) visit_pixels(const DecodedPhoto& photo, Use use) {
  if (photo.kind == PixelKind::u8_srgb) return visit_channels<std::uint8_t>(photo, use);
  if (photo.kind == PixelKind::u16_srgb) return visit_channels<std::uint16_t>(photo, use);
  return visit_channels<float>(photo, use);
}

}  // namespace bosk
