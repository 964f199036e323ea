#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/calibrate/bundle.h"
#include "core/geometry/similarity.h"

namespace bosk {

// Which of the seven moves of the world the survey determines. `free` are the others, along which
// nothing that was measured changes by a sigma.
struct Determined {
  bool scale = false, up = false, heading = false, place = false, ground = false;
  std::vector<GaugeMove> free;
};

// How far a move may reach before what was measured objects, else the move is free: metres per
// metre of the scene, radians, relative growth. A survey weaker than that determines nothing.
inline constexpr double kWeakestSurvey = 0.1;

// Puts the world where the survey wants it: scale from lengths, bodies, heights and surveyed
// points, up from heights, sticks, gravity and surveyed points, all in one weighted fit of a
// similarity (from closed-form beginnings), with what was solved kept as it is. `problem` says what
// was measured. What the survey leaves free is chosen: up as the cameras' plane has it, unit of the
// mean distance from cameras to the trunk, trunk at the origin (the point nearest to all viewing
// axes), the lowest point on the ground, the first camera at -y. Bodies are placed on their points.
Determined place_in_world(const BundleProblem& problem, BundleState& state);

// What the rows that are used determine of a world that was placed.
Determined determined_by(const BundleProblem& problem, const BundleState& state);

// Nearest to all viewing axes; the mean of the points where the axes are parallel.
glm::dvec3 crown_point(const BundleState& state);

// The direction that rises from the plane of the camera centres, on the side where photos have
// their top; the mean of the photos' tops where the centres lie on a line.
glm::dvec3 up_of_cameras(std::span<const RigidTransform> camera_from_world);

BundleState moved(const BundleState& state, const Similarity& target_from_source);

}  // namespace bosk
