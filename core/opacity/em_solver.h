#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/opacity/ray_cache.h"

namespace bosk {

// One pass of multiplicative least-squares EM over all rays in `subsets` interleaved subsets, each
// followed by an update:
//   s_p = sum_i w_pi tau_i,  E = exp(-s_p)
//   tau_i <- tau_i * sum_p w_pi alpha_p E / sum_p w_pi (1 - E) E
// with w_pi the trilinear weight of cell i along ray p. Stays non-negative by itself and needs no
// step size. Returns the mean |alpha - matte| before the updates. `extinction` has one entry per
// cell. Least squares rather than cross-entropy: with ordered subsets the latter diverges in dense
// crowns.
double em_pass(const RayCache& cache, const TrilinearSupport& support, int subsets,
               std::vector<float>& extinction, Progress& progress);

}  // namespace bosk
