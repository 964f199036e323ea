#pragma once

#include "core/base/progress.h"
#include "core/calibrate/calibration.h"
#include "core/project/cache.h"
#include "core/project/calibration_sources.h"
#include "core/project/project.h"

namespace bosk {

// As run_calibration and, where `calibrate.refine` asks for it, the cameras then refined by the
// mattes (core/radiance/pose_refinement.h), which are made where they aren't stored. A sentence
// says what came of it; figures of photos and points stay those of the solve. Refined once for each calibration, whatever becomes of the mattes later.
// Throws Error as run_calibration does, and where refining needs mattes that nothing tells yet; the
// cameras as solved are stored then. Cancelled.
Calibration calibrate_project(const Project& project, const CalibrationSources& sources,
                              const Cache& cache, Progress& progress);

}  // namespace bosk
