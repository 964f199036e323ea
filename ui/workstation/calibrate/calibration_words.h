#pragma once

#include <optional>
#include <string>

#include "core/calibrate/calibration.h"
#include "core/calibrate/survey.h"
#include "ui/widgets/theme.h"

namespace bosk {

// What the words of core/project/calibration_figures.h are said in.
Tone tone_of(Verdict verdict);
Tone tone_of(PhotoFate fate);

// "2 photos are uncertain: 003, 007"; empty where all photos are well placed.
std::string troubled_photos(const Calibration& calibration, PhotoFate fate);

// Why it can't be added yet; empty when it can.
std::string obstacle_to_tape(const Tape& tape);

// How far the solved length is from the tape: "solved 1.204 m, +4 mm (2.0 sigma)"; none where an
// end has no place or the scale isn't known.
std::optional<std::string> tape_words(const Calibration& calibration, const Tape& tape);
// The same of a height.
std::optional<std::string> height_words(const Calibration& calibration, const Height& height);

}  // namespace bosk
