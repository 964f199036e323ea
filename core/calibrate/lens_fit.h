#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/lens_bundle.h"

namespace bosk {

// Boards that agree on one lens.
struct LensFit {
  std::vector<std::size_t> boards;  // their numbers in the problem given
  LensProblem problem;              // they alone, outliers marked
  LensState state;
  std::vector<std::size_t> misfits;  // numbers of the boards that were left out on the way
};

// A lens of `family` for all boards that fit one: seeds, then frees focal lengths and centre, then
// distortion, then (`warp`) the board's shape. A board whose corners miss by over three times what
// most boards' do is left out, the worst one at a time; then outliers are marked, until neither is
// found; then all that were left out are judged once more by the lens found. None when nothing
// gives a seed.
std::optional<LensFit> fit_lens(const LensProblem& problem, LensFamily family, bool warp,
                                Progress& progress);

}  // namespace bosk
