#include "core/matte/clean_alpha.h"

#include <algorithm>

namespace bosk {

void stretch_ends(Image<float>& alpha, float clear_below, float opaque_above) {
  const float scale = 1.0f / std::max(opaque_above - clear_below, 1e-3f);
  for (float& value : alpha.pixels()) value = std::clamp((value - clear_below) * scale, 0.0f, 1.0f);
}

}  // namespace bosk
