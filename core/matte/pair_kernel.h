#pragma once

#include <cstddef>

#include "core/matte/mixing.h"

namespace bosk {

constexpr std::size_t kRun = 64;  // pixels handled together

// A run of pixels of one row, kRun values each, and what is known before their colours are looked
// at.
struct PixelRun {
  const float *l = nullptr, *a = nullptr, *b = nullptr;  // CIELab
  const float* foreground_log_weight = nullptr;          // kRun values per foreground cluster
  const float* background_log_weight = nullptr;          // kRun values per background cluster
  const float* tilt = nullptr;  // natural logarithm of how much likelier opaque is than clear
};

struct AlphaRun {
  float* alpha = nullptr;  // mean over all explanations, weighted by how well they fit the colour
  float* likelihood = nullptr;  // natural logarithm of the sum of the weights
};

// After Ruzon and Tomasi 2000, section 4. Differs: curved paths in place of straight lines,
// positions in place of windows, and explanations by one pure colour beside those by two.
void alpha_of_run(const MixedColours& colours, const PixelRun& run, float* scratch,
                  const AlphaRun& result);
std::size_t scratch_size(const MixedColours& colours);

}  // namespace bosk
