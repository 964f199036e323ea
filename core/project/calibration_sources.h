#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibrate/calibrate_options.h"
#include "core/photo/decode.h"
#include "core/project/calibration_inputs.h"
#include "core/project/source_files.h"

namespace bosk {

// All that calibration starts from, gathered from the project's files; its result is a function of
// this.
struct CalibrationSources {
  std::vector<SourceFile> photos;     // by name
  std::vector<SourceFile> boards;     // photos of a board, by name
  std::optional<SourceFile> profile;  // of the lens
  HandSightings sightings;            // of the project's photos alone
  Strokes left_out;                   // the same
  Measurements measurements;
  CalibrateOptions options;
  DecodeLimits limits;               // no part of the result
  std::vector<std::string> remarks;  // one sentence for each thing told that is not used
};

// Reads every file. Throws Error when one can't be read or there is no photo.
CalibrationSources gather_calibration(const Project& project);
// The sources with these sightings and measurements: quick, since no file is read again.
void take_inputs(CalibrationSources& sources, const CalibrationInputs& inputs);

// The key of the calibration: content of the files, what a person told, options; no paths.
ContentHash calibration_key(const CalibrationSources& sources);

}  // namespace bosk
