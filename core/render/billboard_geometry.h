#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/package/tree_model.h"

namespace bosk {

// Every third bit of a Morton code, packed: bit 0, 3, 6 ... of `code` become bit 0, 1, 2 ...
inline std::uint32_t every_third_bit(std::uint64_t code) {
  code &= 0x1249249249249249u;
  code = (code ^ (code >> 2)) & 0x10c30c30c30c30c3u;
  code = (code ^ (code >> 4)) & 0x100f00f00f00f00fu;
  code = (code ^ (code >> 8)) & 0x001f0000ff0000ffu;
  code = (code ^ (code >> 16)) & 0x001f00000000ffffu;
  code = (code ^ (code >> 32)) & 0x00000000001fffffu;
  return static_cast<std::uint32_t>(code);
}

// Cell coordinates along x, y, z within their level.
inline glm::uvec3 cell_from_morton(std::uint64_t code) {
  return {every_third_bit(code), every_third_bit(code >> 1), every_third_bit(code >> 2)};
}

inline double cell_size_m(const TreeModel& model, int level) {
  return std::ldexp(model.size_m, -level);
}

inline glm::dvec3 cell_centre_in_world(const TreeModel& model, int level, std::uint64_t code) {
  const glm::dvec3 cell(cell_from_morton(code));
  return model.origin + (cell + 0.5) * cell_size_m(model, level);
}

struct BillboardAxes {
  glm::dvec3 right{1.0, 0.0, 0.0};  // the texture's x axis
  glm::dvec3 up{0.0, 0.0, 1.0};     // against the texture's rows
};

// Unit axes of the square that faces `eye` (package/tree_model.h). `eye` and `centre` differ.
inline BillboardAxes billboard_axes(const glm::dvec3& centre, const glm::dvec3& eye) {
  const glm::dvec3 forward = glm::normalize(centre - eye);
  const double horizontal = std::hypot(forward.x, forward.y);
  glm::dvec3 right(1.0, 0.0, 0.0);
  if (horizontal > 1e-6) right = glm::dvec3(forward.y, -forward.x, 0.0) / horizontal;
  return {right, glm::cross(right, forward)};
}

}  // namespace bosk
