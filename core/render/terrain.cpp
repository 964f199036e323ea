#include "core/render/terrain.h"

#include <cmath>

#include "core/base/random.h"

namespace bosk {
namespace {

constexpr int kOctaves = 4;
// Each octave is half as wide and as high as the last; together they reach 1.
constexpr double kFirstShare = 1.0 / (1.0 + 0.5 + 0.25 + 0.125);

// -1 to 1, of one corner of the lattice.
double corner_value(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  Random column(seed, std::uint64_t(x));
  return Random(column.bits(), std::uint64_t(y)).uniform(-1.0, 1.0);
}

// From 0 to 1 with slope and curvature 0 at both ends (Perlin 2002).
double smooth(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

double value_noise(std::uint64_t seed, double x, double y) {
  const double left = std::floor(x), low = std::floor(y);
  const auto column = std::int64_t(left), row = std::int64_t(low);
  const double across = smooth(x - left), along = smooth(y - low);
  const double front =
      std::lerp(corner_value(seed, column, row), corner_value(seed, column + 1, row), across);
  const double back = std::lerp(corner_value(seed, column, row + 1),
                                corner_value(seed, column + 1, row + 1), across);
  return std::lerp(front, back, along);
}

}  // namespace

double height_at(const Terrain& terrain, double x, double y) {
  const double plane = terrain.base_m + glm::dot(terrain.slope, glm::dvec2(x, y));
  if (terrain.relief_m == 0.0) return plane;
  double sum = 0.0, share = kFirstShare, width = terrain.hill_m;
  for (int octave = 0; octave < kOctaves; ++octave, share *= 0.5, width *= 0.5) {
    if (width < terrain.finest_m) break;
    sum += share * value_noise(terrain.seed + std::uint64_t(octave), x / width, y / width);
  }
  return plane + 0.5 * terrain.relief_m * sum;
}

glm::dvec3 normal_at(const Terrain& terrain, double x, double y) {
  const double step = 1e-3 * terrain.hill_m;
  const double slope_x = height_at(terrain, x + step, y) - height_at(terrain, x - step, y);
  const double slope_y = height_at(terrain, x, y + step) - height_at(terrain, x, y - step);
  return glm::normalize(glm::dvec3(-slope_x, -slope_y, 2.0 * step));
}

Terrain plane_through(std::span<const glm::dvec3> points) {
  if (points.empty()) return {};
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& point : points) mean += point / double(points.size());

  // Normal equations around the mean, kept solvable where points lie on a line
  double xx = 0.0, xy = 0.0, yy = 0.0;
  glm::dvec2 rise(0.0);
  for (const glm::dvec3& point : points) {
    const glm::dvec3 away = point - mean;
    xx += away.x * away.x;
    xy += away.x * away.y;
    yy += away.y * away.y;
    rise += glm::dvec2(away) * away.z;
  }
  const double tiny = 1e-9 * (xx + yy) + 1e-12;
  xx += tiny;
  yy += tiny;
  Terrain plane;
  plane.slope =
      glm::dvec2(yy * rise.x - xy * rise.y, xx * rise.y - xy * rise.x) / (xx * yy - xy * xy);
  plane.base_m = mean.z - glm::dot(plane.slope, glm::dvec2(mean));
  return plane;
}

}  // namespace bosk
