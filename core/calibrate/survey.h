#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace bosk {

// What a person measured at the tree; all in metres, every sigma_m > 0. Points are those of
// Sighting::point.

struct Tape {
  std::string from, to;
  double length_m = 0.0, sigma_m = 0.002;
  bool operator==(const Tape&) const = default;
};

// Above the ground at the foot of the trunk: a stick's length up to its ball's centre.
struct Height {
  std::string point;
  double height_m = 0.0, sigma_m = 0.005;
  bool operator==(const Height&) const = default;
};

struct SurveyedPoint {
  std::string point;
  glm::dvec3 in_world{0.0};
  double sigma_m = 0.005;
  bool operator==(const SurveyedPoint&) const = default;
};

// Points whose places relative to each other are known: a board, a printed marker.
struct RigidBody {
  std::string name;
  std::vector<std::string> points;
  std::vector<glm::dvec3> in_body;  // beside `points`, metres
};

struct Survey {
  std::vector<Tape> tapes;
  std::vector<Height> heights;
  std::vector<SurveyedPoint> points;
  std::vector<RigidBody> bodies;

  bool gives_scale() const {
    return !tapes.empty() || !heights.empty() || points.size() >= 2 || !bodies.empty();
  }
};

}  // namespace bosk
