#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/photo/decode.h"

namespace bosk {

// One resampling from the photo as taken to the undistorted photo at the working size. Each pixel
// of the result is a mean over its own footprint in the original, in linear light and weighted by
// alpha: Catmull-Rom interpolation, widened by a box where the original is finer (README.md). Where
// both lenses agree the pixels are copied. Beyond the original's edge its last pixels repeat; where
// the lens has no answer the result is clear black. Straight sRGB-encoded colour and alpha, 0 to 1;
// colour where alpha is 0 is that of the surroundings in the file. `original` must have the photo's
// size; `working` is a pinhole.
Image<glm::vec4> undistorted_photo(const DecodedPhoto& photo, const Lens& original,
                                   const Lens& working);

// Takes an imported matte through exactly the mapping that its photo went through. A matte of
// another size than the original lens, but of the same shape, is taken as the photo scaled; Error
// for another shape.
Image<glm::vec4> undistort_rgba(const Image<glm::vec4>& straight, const Camera& original,
                                const Camera& working);

// The lens for a photo of this size: the same lens, scaled where the shape agrees to a pixel. Error
// that says how they differ otherwise.
Lens lens_for_size(const Lens& lens, int width_px, int height_px);

// Weight of the original pixel at distance `offset` (px) in a result whose pixels are `scale` (1 or
// more) original pixels wide. Weights at offsets one pixel apart sum to 1.
double resampling_weight(double offset, double scale);
// Weights are 0 from this distance on.
double resampling_radius(double scale);

}  // namespace bosk
