#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/radiance/radiance.h"

namespace bosk {

// How much of the light of each octree cell of `level` (Morton codes) reaches each viewpoint
// through the rest of the crown: [cell][view], 0 to 1. Estimated on a coarse copy of the volume,
// starting one coarse cell in front of the cell's centre, so that a cell does not hide itself.
std::vector<float> transmittance_to_views(const RadianceVolume& volume, int level,
                                          const std::vector<std::uint64_t>& cells,
                                          const std::vector<glm::dvec3>& views, Progress& progress);

}  // namespace bosk
