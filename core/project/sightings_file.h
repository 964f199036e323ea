#pragma once

#include <filesystem>

#include "core/project/calibration_inputs.h"
#include "core/project/project.h"

namespace bosk {

// What a person says about photos, by photo.
struct HandFile {
  HandSightings sightings;
  Strokes left_out;
};

// Clicks from elsewhere, as JSON: a list of {"photo", "point", "x", "y"}, pixels of the photo as
// delivered with (0, 0) the centre of the first; {"photo", "point", "removed": true} says that the
// point is not seen there; {"photo", "left_out": [[x, y], ...], "radius": r} that nothing is to be
// looked for within r of a line. Photos are named as in the project, or with their ending. Throws
// Error that names file and entry where one is damaged, told twice, or none is of a photo of the
// project.
HandFile read_sightings_file(const std::filesystem::path& path, const Project& project);

}  // namespace bosk
