#pragma once

#include "core/base/binary.h"
#include "core/calibrate/calibration.h"
#include "core/calibrate/features.h"
#include "core/calibrate/lens_solve.h"

namespace bosk {

// Results of calibration as the cache holds them (binary.h). Reading throws Error where the bytes
// are no such result.
void write(BinaryWriter& writer, const Calibration& calibration);
Calibration read_calibration(BinaryReader& reader);
void write(BinaryWriter& writer, const LensCalibration& calibration);
LensCalibration read_lens_calibration(BinaryReader& reader);
void write(BinaryWriter& writer, const FeatureSightings& features);
FeatureSightings read_feature_sightings(BinaryReader& reader);

}  // namespace bosk
