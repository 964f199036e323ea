#include "core/project/calibration_inputs.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/system_error.h"
#include "core/project/project_json.h"

namespace bosk {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(printable(what) + ": " + why);
}

void check_name(const std::string& point) {
  if (point.empty()) throw Error("a point without a name; give it one");
  if (!is_storable(point)) refuse(point, "the name is not valid UTF-8; choose another");
}

bool is_within(double value, double largest) {
  return std::isfinite(value) && std::abs(value) <= largest;
}

void check_sigma(const std::string& what, double sigma_m) {
  if (sigma_m > 0.0 && is_within(sigma_m, kMaxMeasurementM)) return;
  refuse(what, "the tolerance must be more than 0 metres");
}

void check(const Tape& tape) {
  check_name(tape.from);
  check_name(tape.to);
  const std::string what = "tape from " + tape.from + " to " + tape.to;
  if (tape.from == tape.to) refuse(what, "must lead from one point to another");
  if (!(tape.length_m > 0.0) || !is_within(tape.length_m, kMaxMeasurementM)) {
    refuse(what, "the length must be more than 0 metres, and at most 100 km");
  }
  check_sigma(what, tape.sigma_m);
}

void check(const Height& height) {
  check_name(height.point);
  const std::string what = "height of " + height.point;
  if (!is_within(height.height_m, kMaxMeasurementM)) refuse(what, "give a number of metres");
  check_sigma(what, height.sigma_m);
}

void check(const SurveyedPoint& point) {
  check_name(point.point);
  const std::string what = "surveyed point " + point.point;
  for (int i = 0; i < 3; ++i) {
    if (!is_within(point.in_world[i], kMaxMeasurementM)) refuse(what, "give numbers of metres");
  }
  check_sigma(what, point.sigma_m);
}

}  // namespace

void check(const std::string& point, const HandSighting& sighting) {
  check_name(point);
  if (is_within(sighting.pixel.x, kMaxSightingPx) && is_within(sighting.pixel.y, kMaxSightingPx)) {
    return;
  }
  refuse("sighting of " + point, "its place is no pixel");
}

void check(const Measurements& measurements) {
  for (const Tape& tape : measurements.tapes) check(tape);
  for (const Height& height : measurements.heights) check(height);
  for (const SurveyedPoint& point : measurements.points) check(point);
}

Survey survey_of(const Measurements& measurements) {
  return {measurements.tapes, measurements.heights, measurements.points, {}};
}

}  // namespace bosk
