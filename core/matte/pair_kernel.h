#pragma once

#include <cstddef>
#include <vector>

#include "core/matte/mixing.h"

namespace bosk {

constexpr std::size_t kRun = 64;  // pixels handled together

// A run of pixels of one row and what is known about each before its colour is looked at.
struct PixelRun {
  const float *l = nullptr, *a = nullptr, *b = nullptr;  // CIELab, kRun values each
  const float* foreground_log_weight = nullptr;          // kRun values per foreground cluster
  const float* background_log_weight = nullptr;          // kRun values per background cluster
  const float* tilt =
      nullptr;  // natural logarithm of how much likelier 1 is than 0, before the colour
};

struct AlphaRun {
  float* alpha = nullptr;       // mean over all pairs, weighted by how well they explain the colour
  float* likelihood = nullptr;  // logarithm of the sum of the weights: how well any pair does
};

// After Ruzon and Tomasi 2000, section 4, with paths in place of straight lines. `scratch` needs
// 2 * kRun values per path.
void alpha_of_run(const std::vector<MixingPath>& paths, const PixelRun& run, float* scratch,
                  const AlphaRun& result);

}  // namespace bosk
