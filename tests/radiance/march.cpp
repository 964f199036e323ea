#include "march.h"

#include <cmath>

#include "core/radiance/harmonics.h"

namespace bosk {

glm::vec4 slow_march(const RadianceVolume& volume, const RayCache& cache, const CachedRay& ray,
                     const TrilinearSupport& support) {
  const auto basis = harmonics(ray.direction);
  const auto terms = std::size_t(volume.coefficients());
  glm::dvec3 colour(0.0);
  double left = 1.0;
  for_each_sample(cache, ray, support, [&](std::int32_t number, const glm::vec3& fraction) {
    float weights[8];
    trilinear_weights(fraction, weights);
    glm::dvec3 weighted(0.0);
    double extinction = 0.0;
    for (int i = 0; i < 8; ++i) {
      const auto cell = std::size_t(support.corners(number).number[i]);
      if (cell >= volume.grid.size()) continue;
      const double part = double(weights[i]) * double(volume.extinction[cell]);
      extinction += part;
      for (std::size_t j = 0; j < terms; ++j) {
        const float* c = &volume.colour[(cell * terms + j) * 3];
        weighted += part * double(basis[j]) * glm::dvec3(c[0], c[1], c[2]);
      }
    }
    if (extinction <= 0.0) return true;
    colour += left * (1.0 - std::exp(-extinction)) * weighted / extinction;
    left *= std::exp(-extinction);
    return true;
  });
  return {glm::vec3(colour), float(1.0 - left)};
}

MarchError march_error(const RadianceVolume& volume, const RayCache& cache,
                       const TrilinearSupport& support) {
  double colour = 0.0, alpha = 0.0;
  for (const CachedRay& ray : cache.rays) {
    const glm::dvec4 off(slow_march(volume, cache, ray, support) - ray.target);
    colour += glm::dot(glm::dvec3(off), glm::dvec3(off)) / 3.0;
    alpha += off.a * off.a;
  }
  const auto rays = double(cache.rays.size());
  return {std::sqrt(colour / rays), std::sqrt(alpha / rays)};
}

}  // namespace bosk
