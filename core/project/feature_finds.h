#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/project/calibration_finds.h"

namespace bosk {

// Whether features are to be looked for: as the option says; with `auto` where a photo shows too
// few points that others show too.
bool needs_features(const std::vector<PhotoSightings>& photos, const CalibrateOptions& options);

// Whether they were.
bool finds_features(const CalibrationFinds& finds);

// Adds the features of the photos (those of the lens's size) to the finds, with first poses and,
// where the lens was a guess, its better focal length; from the cache where they are kept. Throws
// Error where a photo can't be read any more; Cancelled.
void add_features(const CalibrationSources& sources, const Cache& cache, CalibrationFinds& finds,
                  Progress& progress);

}  // namespace bosk
