#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace bosk {

// A smooth, made-up ground without end: value noise of four octaves, the same on every machine.
struct Terrain {
  double relief_m = 0.0;  // heights stay within half of it above and below the plane
  double hill_m = 80.0;   // from one hill to the next, about; above 0
  std::uint64_t seed = 1;
  double finest_m = 0.0;  // octaves narrower than it are left out: for a ground drawn coarsely
  // The plane that hills rise from and sink below: height over (0, 0), and its rise a metre of x,
  // y.
  double base_m = 0.0;
  glm::dvec2 slope{0.0};
};

// Metres above z = 0. Slopes have no steps.
double height_at(const Terrain& terrain, double x, double y);

// Of unit length, upwards.
glm::dvec3 normal_at(const Terrain& terrain, double x, double y);

// The plane without hills that lies nearest to the points (least squares in z). Points in one place
// or on one line leave the slope across them at 0; no points: z = 0.
Terrain plane_through(std::span<const glm::dvec3> points);

}  // namespace bosk
