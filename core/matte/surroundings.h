#pragma once

#include <cstdint>

#include "core/image/image.h"
#include "core/matte/alpha.h"
#include "core/matte/stroke_model.h"

namespace bosk {

// Reach of the near surroundings that photos are compared by (hull.h), in image diagonals.
constexpr float kOutlineSigma = 0.012f;

// Mean alpha around each cell of a coarse grid, `sigma` image diagonals wide. Strokes count more
// than estimates; `strokes` is empty or has the size of `alpha`.
Image<float> mean_alpha(const Image<float>& alpha, const Image<std::uint8_t>& strokes, float sigma);

// How much likelier opaque is than clear (natural logarithm) where the surroundings have this mean
// alpha.
Image<float> region_tilt(const Image<float>& mean_alpha, float weight);

// The same from the strokes' places alone: positive where foreground strokes are nearer, up to
// `weight`.
Image<float> position_tilt(const StrokeModel& model, float weight);

// The same from strokes of one kind over a photo that another one teaches: up to `weight` on them,
// half of it a twentieth of the diagonal away. `strokes` may be of any size.
Image<float> correction_tilt(const Image<std::uint8_t>& strokes, float weight);

// The grid stretched to another number of cells.
Image<float> stretched(const Image<float>& grid, int width, int height);

// a + b, b stretched to the grid of a.
Image<float> sum_of_grids(const Image<float>& a, const Image<float>& b);

}  // namespace bosk
