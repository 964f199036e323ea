#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/calibrate/calibration.h"

namespace bosk {

// "good", "usable, with reservations", "refused".
std::string verdict_words(Verdict verdict);
// "placed", "uncertain", "not placed".
std::string fate_words(PhotoFate fate);
// "22 of 24 photos placed, 0.46 px, scale within 0.2 %": what comes behind the verdict.
std::string summary_words(const Calibration& calibration);

// Of features there are too many to list.
bool is_feature(const std::string& point);
// "red foot": of the stick under the ball that is called red.
bool is_foot(const std::string& point);

// One sigma of a place, over all three axes, in the units of the world.
double spread(const glm::dmat3& covariance);

// Verdict and sentences, then a table of the photos and one of the markers.
std::string calibration_figures_text(const Calibration& calibration);
// All of it: figures of photos and points, residuals, lens. Places in metres, pixels of the photos
// as delivered.
nlohmann::ordered_json calibration_figures_json(const Calibration& calibration);

}  // namespace bosk
