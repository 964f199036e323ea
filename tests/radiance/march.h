#pragma once

#include <glm/glm.hpp>

#include "core/opacity/ray_cache.h"
#include "core/radiance/radiance.h"

namespace bosk {

// Premultiplied colour and alpha along a cached ray: emission-absorption written out plainly, the
// judge of the fit's own march.
glm::vec4 slow_march(const RadianceVolume& volume, const RayCache& cache, const CachedRay& ray,
                     const TrilinearSupport& support);

// Root mean square of the difference to the rays' targets: colour and alpha.
struct MarchError {
  double colour = 0.0, alpha = 0.0;
};
MarchError march_error(const RadianceVolume& volume, const RayCache& cache,
                       const TrilinearSupport& support);

}  // namespace bosk
