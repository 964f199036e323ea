#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace bosk {

// A smooth, made-up ground without end: value noise of four octaves, the same on every machine.
struct Terrain {
  double relief_m = 0.0;  // heights stay within half of it above and below 0; 0: flat
  double hill_m = 80.0;   // from one hill to the next, about; above 0
  std::uint64_t seed = 1;
};

// Metres above z = 0. Slopes have no steps; 0 everywhere when the relief is 0.
double height_at(const Terrain& terrain, double x, double y);

// Of unit length, upwards.
glm::dvec3 normal_at(const Terrain& terrain, double x, double y);

}  // namespace bosk
