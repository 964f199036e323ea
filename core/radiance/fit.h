#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/opacity/ray_cache.h"
#include "core/radiance/radiance.h"

namespace bosk {

// How one fit of one level runs.
struct FitSchedule {
  int epochs = 4;                     // passes over all rays
  int subsets = 48;                   // interleaved updates per epoch
  float extinction_rate = 0.1f;       // first step size, relative to clamp(extinction, 0.3, 3)
  float colour_rate = 0.06f;          // first step size of the mean colour
  float harmonics_rate = 0.015f;      // and of the higher coefficients
  double colour_variation = 0.0;      // weight of the total variation of colour, per ray
  double extinction_variation = 0.0;  // and of extinction
  float harmonics_decay = 0.02f;  // pull of the higher coefficients to zero: views that no photo
                                  // saw get the mean colour
};

// Fits volume.extinction and volume.colour to the cached rays by Adam on
//   sum over rays |C - C*|^2 + (alpha - alpha*)^2,
//   C = sum_k T_k a_k c_k,  alpha = 1 - T_end,  a_k = 1 - exp(-extinction_k),  T_k = prod_j<k (1 -
//   a_j)
// with samples one cell apart; extinction is trilinear between the cells' centres, colour the mean
// of the cells' colours weighted by what each adds to the extinction, everything premultiplied and
// sRGB-encoded (emission-absorption model, as in volume rendering; Max 1995). Calls
// `after_epoch(psnr_db)`, which says whether to go on.
void fit_volume(RadianceVolume& volume, const RayCache& cache, const TrilinearSupport& support,
                const FitSchedule& schedule, Progress& progress,
                const std::function<bool(double)>& after_epoch);

// Sets the mean colour of each cell to the photos' straight colours, each weighted by how much of
// the pixel the cell makes up; the higher coefficients to zero.
void back_project_colour(RadianceVolume& volume, const RayCache& cache,
                         const TrilinearSupport& support, Progress& progress);

// The largest share that each cell has in any ray: its visibility, 0 to 1.
std::vector<float> cell_visibility(const RadianceVolume& volume, const RayCache& cache,
                                   const TrilinearSupport& support, Progress& progress);

}  // namespace bosk
