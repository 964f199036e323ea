#pragma once

#include <cstdint>

#include "core/image/image.h"

namespace bosk {

// Squared distance, in pixels, from each pixel to the nearest one where `marked` is not zero; a
// very large number everywhere when nothing is marked. Exact (Felzenszwalb and Huttenlocher 2012:
// one pass over columns, one over rows).
Image<float> squared_distance_to(const Image<std::uint8_t>& marked);

}  // namespace bosk
