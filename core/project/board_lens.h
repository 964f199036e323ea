#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/lens_solve.h"
#include "core/calibrate/solve.h"
#include "core/project/cache.h"
#include "core/project/calibration_sources.h"
#include "core/project/photo_finds.h"

namespace bosk {

// What is known of the lens before the solve, and from where.
struct LensChoice {
  LensKnowledge knowledge;  // at the size of most photos
  std::optional<LensCalibration> boards;
  std::vector<std::string> sentences;
};

// The lens of the photos: from the profile, else from the board photos, else guessed from EXIF;
// fixed as the option `lens` says. Boards that determine no lens, or that another lens took, leave
// a sentence and a guess. Throws Error where the option asks for a known lens and there is none, no
// board photo shows the board, or the profile is damaged or another lens's; Cancelled.
LensChoice choose_lens(const CalibrationSources& sources, const std::vector<PhotoFinds>& photos,
                       const Cache& cache, Progress& progress);

}  // namespace bosk
