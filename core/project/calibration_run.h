#pragma once

#include <optional>

#include "core/base/progress.h"
#include "core/calibrate/calibration.h"
#include "core/project/cache.h"
#include "core/project/calibration_finds.h"
#include "core/project/calibration_sources.h"

namespace bosk {

// Cameras from what was found and what a person told: a click counts over what was found, and a
// point that was removed stays removed. Quick where find_for_calibration is slow, so that it can
// follow the mouse. A refused solve comes back as such, with sentences. Photos that could not be
// read are among the findings. Throws Error where what was told contradicts itself; Cancelled.
Calibration solve_calibration(const CalibrationFinds& finds, const CalibrationSources& sources,
                              Progress& progress);

// What the cache holds of just these sources, refined where they ask for it and it was done; none
// where they were not calibrated yet.
std::optional<Calibration> stored_calibration(const CalibrationSources& sources,
                                              const Cache& cache);
// Keeps it there, also where it is refused, so that nobody waits for the same refusal twice.
void store_calibration(const CalibrationSources& sources, const Calibration& calibration,
                       double seconds, const Cache& cache);

// Cameras refined by the mattes, beside the calibration that they come from.
std::optional<Calibration> stored_refinement(const CalibrationSources& sources, const Cache& cache);
void store_refinement(const CalibrationSources& sources, const Calibration& calibration,
                      double seconds, const Cache& cache);

// The stored calibration or, where there is none, one that is found, solved and stored now. Errors
// as of find_for_calibration and solve_calibration; then nothing is stored but the finds.
Calibration run_calibration(const CalibrationSources& sources, const Cache& cache,
                            Progress& progress);

// "no cameras could be found for the photos: " with the most important sentence.
std::string refusal_of(const Calibration& calibration);
// Throws Error that says so when no cameras are given.
void require_cameras(const Calibration& calibration);

// What the solve takes: the finds with a person's say over them, without what is left out.
std::vector<PhotoSightings> told_sightings(const CalibrationFinds& finds,
                                           const CalibrationSources& sources,
                                           std::vector<std::string>& sentences);

}  // namespace bosk
