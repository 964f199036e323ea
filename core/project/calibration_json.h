#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/project/calibration_inputs.h"

namespace bosk {

// "calibration" of project.json; what is empty is left out:
//   {"sightings": {PHOTO: {POINT: [x, y], or null where it is said not to be there}},
//    "tapes": [{"from", "to", "length_m", "sigma_m"}], "heights": [{"point", "height_m",
//    "sigma_m"}], "points": [{"point", "in_world_m": [x, y, z], "sigma_m"}], "boards": PATH,
//    "lens": PATH}
nlohmann::ordered_json calibration_json(const CalibrationInputs& inputs);
// Throws nlohmann's exceptions, or Error in words, when it is damaged.
CalibrationInputs calibration_of(const nlohmann::ordered_json& json);

}  // namespace bosk
