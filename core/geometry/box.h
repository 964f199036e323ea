#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <optional>

namespace bosk {

struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, 1.0};  // of unit length
};

// Axis-aligned box, metres.
struct Box {
  glm::dvec3 lower{0.0};
  glm::dvec3 upper{0.0};

  glm::dvec3 size() const { return upper - lower; }
  glm::dvec3 centre() const { return 0.5 * (lower + upper); }
};

struct RaySpan {
  double enter = 0.0, leave = 0.0;  // metres along the ray, 0 <= enter < leave
};

// The part of the ray inside the box; none when it misses or only touches. A ray that runs exactly in
// a face counts as a miss.
inline std::optional<RaySpan> intersect(const Ray& ray, const Box& box) {
  double enter = 0.0, leave = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    if (direction == 0.0) {
      if (origin <= box.lower[axis] || origin >= box.upper[axis]) return std::nullopt;
      continue;
    }
    const double a = (box.lower[axis] - origin) / direction;
    const double b = (box.upper[axis] - origin) / direction;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter < leave)) return std::nullopt;
  return RaySpan{enter, leave};
}

}  // namespace bosk
