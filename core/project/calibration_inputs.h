#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/calibrate/survey.h"
#include "core/matte/strokes.h"

namespace bosk {

// What a person says about one point in one photo; it counts over what is found there by itself.
struct HandSighting {
  bool there = true;      // false: the point is not seen in this photo, whatever is found
  glm::dvec2 pixel{0.0};  // of the photo as delivered, (0, 0) the centre of the first; where there
  bool operator==(const HandSighting&) const = default;
};
// By the photo's name, then the point's.
using HandSightings = std::map<std::string, std::map<std::string, HandSighting>>;

// Lengths with a tape, heights of balls, and points surveyed otherwise.
struct Measurements {
  std::vector<Tape> tapes;
  std::vector<Height> heights;
  std::vector<SurveyedPoint> points;

  bool operator==(const Measurements&) const = default;
  bool empty() const { return tapes.empty() && heights.empty() && points.empty(); }
};

// What calibration takes from a person, beside the photos and the options.
struct CalibrationInputs {
  HandSightings sightings;
  Strokes left_out;  // where nothing is to be found: sky, and what moves (left_out.h)
  Measurements measurements;
  std::filesystem::path boards;  // folder with photos of a board, for the lens
  std::filesystem::path lens;    // a lens profile (core/calibrate/lens_profile.h)

  bool empty() const {
    return sightings.empty() && left_out.empty() && measurements.empty() && boards.empty() && lens.empty();
  }
};

inline constexpr double kMaxSightingPx = 1e6;    // of a place, either side of zero
inline constexpr double kMaxMeasurementM = 1e5;  // of a length, a height, a coordinate

// Throw Error, naming the point, when a name is empty or no valid UTF-8, or a number is none or out
// of range: lengths above 0, heights and coordinates either side of 0, every sigma above 0.
void check(const std::string& point, const HandSighting& sighting);
void check(const Measurements& measurements);

// Survey without rigid bodies.
Survey survey_of(const Measurements& measurements);

}  // namespace bosk
