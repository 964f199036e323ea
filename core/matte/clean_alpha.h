#pragma once

#include "core/image/image.h"

namespace bosk {

// Sets alpha below `clear_below` to 0 and above `opaque_above` to 1, and spreads what lies between
// over the whole range, so that no step appears.
void stretch_ends(Image<float>& alpha, float clear_below, float opaque_above);

}  // namespace bosk
