#include "core/calibrate/survey_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"

namespace bosk {
namespace {

constexpr double kStickLean = 0.02;     // radians, of a stick that was set upright by eye
constexpr double kGravityError = 0.02;  // radians, of a phone's sensor
constexpr double kPrintError_m = 2e-4;  // of a printed point's place on its body

void check_positive(double value, const std::string& what) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw Error(what + " isn't a number above 0: measure it again");
}

std::optional<int> index_of(const SolveInput& input, const std::string& point) {
  const auto found = std::lower_bound(input.points.begin(), input.points.end(), point);
  if (found == input.points.end() || *found != point) return std::nullopt;
  return int(found - input.points.begin());
}

// "blue, red, yellow"; empty where these are too many to read. Feet go with their balls.
std::string names_of(const std::vector<std::string>& points) {
  constexpr std::size_t kMostNames = 12;
  std::string names;
  std::size_t count = 0;
  for (const std::string& point : points) {
    if (point.ends_with(" foot")) continue;
    names += (names.empty() ? "" : ", ") + point;
    ++count;
  }
  return count <= kMostNames ? names : "";
}

// The index, or a sentence that what was measured can't be used.
std::optional<int> used_index(SolveInput& input, const std::string& point,
                              const std::string& what) {
  const auto index = index_of(input, point);
  if (!index) {
    const std::string names = names_of(input.points);
    input.sentences.push_back(what + " isn't used: fewer than two photos see " + point +
                              ", so mark it in more" +
                              (names.empty() ? "" : ", or name one of " + names));
  }
  return index;
}

void add_tapes(const Survey& survey, SolveInput& input) {
  for (const Tape& tape : survey.tapes) {
    const std::string what = "the tape from " + tape.from + " to " + tape.to;
    const auto from = used_index(input, tape.from, what), to = used_index(input, tape.to, what);
    if (from && to)
      input.problem.lengths.push_back({*from, *to, tape.length_m, tape.sigma_m, true});
  }
}

void add_heights(const Survey& survey, SolveInput& input) {
  for (const Height& height : survey.heights) {
    const auto point = used_index(input, height.point, "the height of " + height.point);
    if (!point) continue;
    input.problem.coordinates.push_back({*point, 2, height.height_m, height.sigma_m, true});
    if (const auto foot = index_of(input, height.point + " foot"))
      input.problem.lengths.push_back({*foot, *point, height.height_m, height.sigma_m, true});
  }
}

void add_surveyed(const Survey& survey, SolveInput& input) {
  for (const SurveyedPoint& surveyed : survey.points) {
    const auto point = used_index(input, surveyed.point, "the surveyed place of " + surveyed.point);
    for (int axis = 0; point && axis < 3; ++axis)
      input.problem.coordinates.push_back(
          {*point, axis, surveyed.in_world[axis], surveyed.sigma_m, true});
  }
}

// A body needs two seen points to say anything.
void add_bodies(const Survey& survey, SolveInput& input) {
  for (const RigidBody& body : survey.bodies) {
    std::vector<BodyRow> rows;
    for (std::size_t i = 0; i < body.points.size(); ++i)
      if (const auto point = index_of(input, body.points[i]))
        rows.push_back({int(input.bodies.size()), *point, body.in_body[i], kPrintError_m});
    if (rows.size() < 2) continue;
    input.bodies.push_back(body.name);
    input.problem.bodies.insert(input.problem.bodies.end(), rows.begin(), rows.end());
  }
}

void add_sticks(SolveInput& input) {
  for (std::size_t i = 0; i < input.points.size(); ++i)
    if (const auto foot = index_of(input, input.points[i] + " foot"))
      input.problem.plumbs.push_back({int(i), *foot, kStickLean});
}

void add_gravity(std::span<const PhotoSightings> photos, SolveInput& input) {
  for (std::size_t camera = 0; camera < input.cameras(); ++camera)
    if (const auto& up = photos[input.photo_of_camera[camera]].up_in_camera)
      input.problem.ups.push_back({int(camera), glm::normalize(*up), kGravityError});
}

}  // namespace

void check_survey(const Survey& survey) {
  for (const Tape& tape : survey.tapes) {
    const std::string what = "the tape from " + tape.from + " to " + tape.to;
    check_positive(tape.length_m, what);
    check_positive(tape.sigma_m, "the tolerance of " + what);
    if (tape.from == tape.to) throw Error(what + " has one end only: name two points");
  }
  for (const Height& height : survey.heights) {
    check_positive(height.sigma_m, "the tolerance of the height of " + height.point);
    if (!std::isfinite(height.height_m))
      throw Error("the height of " + height.point + " isn't a number: measure it again");
  }
  for (const SurveyedPoint& point : survey.points) {
    check_positive(point.sigma_m, "the tolerance of the surveyed point " + point.point);
    if (!std::isfinite(point.in_world.x + point.in_world.y + point.in_world.z))
      throw Error("the surveyed point " + point.point + " isn't finite: measure it again");
  }
  for (const RigidBody& body : survey.bodies)
    if (body.points.size() != body.in_body.size())
      throw Error("the body " + body.name + " needs one place for each of its points: list both");
}

void add_survey(const Survey& survey, std::span<const PhotoSightings> photos, SolveInput& input) {
  add_tapes(survey, input);
  add_heights(survey, input);
  add_surveyed(survey, input);
  add_bodies(survey, input);
  add_sticks(input);
  add_gravity(photos, input);
}

}  // namespace bosk
