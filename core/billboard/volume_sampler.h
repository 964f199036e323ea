#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/opacity/ray_cache.h"
#include "core/radiance/radiance.h"

namespace bosk {

// Colour and extinction of a volume at any point, trilinear between the cells' centres.
class VolumeSampler {
 public:
  explicit VolumeSampler(const RadianceVolume& volume);

  struct Value {
    glm::vec3 colour{
        0.0f};  // straight, sRGB-encoded, seen along the direction; weighted by extinction
    float extinction = 0.0f;  // per cell edge
  };
  // `at` in cell units (ray_cache.h); `basis` are the harmonics of the direction from the eye.
  Value sample(const glm::vec3& at, const std::array<float, 9>& basis) const;
  float extinction(const glm::vec3& at) const;

 private:
  const RadianceVolume& volume_;
  TrilinearSupport support_;
};

// Premultiplied colour and alpha of the stretch of a ray between two distances (cell units).
glm::vec4 integrate(const VolumeSampler& sampler, const glm::vec3& origin,
                    const glm::vec3& direction, float from, float to,
                    const std::array<float, 9>& basis);

}  // namespace bosk
