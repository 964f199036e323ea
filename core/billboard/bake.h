#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/billboard/billboard.h"
#include "core/billboard/volume_sampler.h"

namespace bosk {

// The finest level: each cell's own trilinear kernel as a texture two cells wide, so that the
// billboards composited over each other are the volume itself. Without view-dependent colour one
// view serves all directions. Fills level.cells and level.texture from the volume's cells.
void bake_kernels(const RadianceVolume& volume, const std::vector<glm::dvec3>& views,
                  BillboardLevel& level, Progress& progress);

// A coarser level: what is inside each cell's cube, composited along parallel rays towards each
// view, averaged over each texel's area. Fills level.texture for level.cells.
void bake_cubes(const RadianceVolume& volume, const VolumeSampler& sampler,
                const std::vector<glm::dvec3>& views, BillboardLevel& level, Progress& progress);

}  // namespace bosk
