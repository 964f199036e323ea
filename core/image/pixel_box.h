#pragma once

#include <glm/glm.hpp>

namespace bosk {

// Pixels [from, to) of an image.
struct PixelBox {
  glm::ivec2 from{0}, to{0};

  bool empty() const { return from.x >= to.x || from.y >= to.y; }
  bool operator==(const PixelBox&) const = default;
};

// The pixels in both.
inline PixelBox overlap(const PixelBox& a, const PixelBox& b) {
  return {glm::max(a.from, b.from), glm::min(a.to, b.to)};
}

// The least box around both; empty ones don't count.
inline PixelBox around(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {glm::min(a.from, b.from), glm::max(a.to, b.to)};
}

}  // namespace bosk
