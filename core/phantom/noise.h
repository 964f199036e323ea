#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace bosk {

inline std::uint32_t hashed(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
  std::uint32_t h =
      a * 0x9e3779b1u ^ (b * 0x85ebca77u + 0x7f4a7c15u) ^ (c * 0xc2b2ae3du + 0x27d4eb2fu);
  h = (h ^ (h >> 16)) * 0x7feb352du;
  h = (h ^ (h >> 15)) * 0x846ca68bu;
  return h ^ (h >> 16);
}

// From 0 up to, never including, 1.
inline float hashed_unit(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
  return float(hashed(a, b, c) >> 8) * 0x1.0p-24f;
}

// Smooth noise of one cycle per unit, 0 to 1 (values on a lattice, faded with 3t^2 - 2t^3).
inline float value_noise(const glm::vec3& point) {
  const glm::vec3 cell = glm::floor(point);
  const glm::vec3 t = point - cell, fade = t * t * (3.0f - 2.0f * t);
  const auto lattice = [&](int x, int y, int z) {
    return hashed_unit(std::uint32_t(int(cell.x) + x), std::uint32_t(int(cell.y) + y),
                       std::uint32_t(int(cell.z) + z));
  };
  const auto row = [&](int y, int z) {
    return glm::mix(lattice(0, y, z), lattice(1, y, z), fade.x);
  };
  const auto slice = [&](int z) { return glm::mix(row(0, z), row(1, z), fade.y); };
  return glm::mix(slice(0), slice(1), fade.z);
}

// Octaves of value noise, each twice as fine and half as strong; 0 to 1, mean 0.5.
inline float fractal_noise(glm::vec3 point, int octaves) {
  float sum = 0.0f, weight = 0.5f, total = 0.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += weight * value_noise(point);
    total += weight;
    weight *= 0.5f;
    point = point * 2.03f + glm::vec3(17.3f, 5.1f, 9.7f);
  }
  return sum / total;
}

}  // namespace bosk
