#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/glm.hpp>

namespace bosk {

// CIELab in cells about as wide as noise and the change of light between photos: 16 of lightness,
// 24 of a* and b* each from -64 to 64, the rest in the outermost.
constexpr int kLightCells = 16, kColourCells = 24;
constexpr std::size_t kAllColourCells = std::size_t(kLightCells) * kColourCells * kColourCells;

inline std::size_t colour_cell(const glm::vec3& lab) {
  constexpr float kRange = 64.0f;
  const int light = std::clamp(int(lab.x / 100.0f * kLightCells), 0, kLightCells - 1);
  const auto cell = [](float value) {
    const float place = (value + kRange) / (2.0f * kRange);
    return std::clamp(int(place * kColourCells), 0, kColourCells - 1);
  };
  return std::size_t((light * kColourCells + cell(lab.y)) * kColourCells + cell(lab.z));
}

}  // namespace bosk
