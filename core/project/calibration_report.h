#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/lens_solve.h"
#include "core/project/calibration_sources.h"

namespace bosk {

// One page that shows a calibration by itself: verdict and sentences, the walk from above, figures
// of each photo and marker, the lens with its coverage and uncertainty where there were boards, and
// every photo with its sightings and residuals. Reads the photos again, which takes as long as
// decoding them; one that can't be read is shown without its picture. Replaced atomically; throws
// Error where it can't be written, Cancelled.
void write_calibration_report(const std::filesystem::path& path, const std::string& title,
                              const CalibrationSources& sources, const Calibration& calibration,
                              const std::optional<LensCalibration>& boards, Progress& progress);

}  // namespace bosk
