#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/random.h"

namespace bosk {

// A circle on the ground that no other one cuts; what stands in it is the caller's.
struct Disc {
  glm::dvec2 centre{0.0};
  double radius = 0.0;
  std::uint32_t kind = 0;
  double scale = 1.0;
};

// Draws the next disc that asks for a place; its radius is above 0.
using DiscSource = std::function<Disc(Random&)>;

// Fills the rectangle of that size around (0, 0) with centres of discs that do not overlap, until
// hardly another one fits, or there are `most`. No disc of the source is above `largest_radius`.
std::vector<Disc> fill_with_discs(const glm::dvec2& size, const DiscSource& source,
                                  double largest_radius, std::size_t most, Random& random);

}  // namespace bosk
