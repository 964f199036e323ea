#pragma once

#include <glm/glm.hpp>
#include <map>
#include <span>
#include <vector>

#include "core/calibrate/bundle.h"

namespace bosk {

// The steps of place_in_world that look at a state as it is.

double mean_distance(const BundleState& state, const glm::dvec3& point);  // of the cameras
double lowest_point(const BundleState& state);                            // its z

// Turns `up`, of unit length, into +z by the shortest way.
glm::dmat3 rotation_to_z(const glm::dvec3& up);

// Directions that may be up: of the sticks, of gravity, of the cameras' plane, of the photos' tops.
std::vector<glm::dvec3> possible_ups(const BundleProblem& survey, const BundleState& state);

// Growth that makes the heights' differences as measured, z being up; 1 where they don't say.
double height_scale(std::span<const CoordinateRow> coordinates, std::span<const glm::dvec3> points);

// Measured minus present coordinates, the mean of each axis; 0 along axes of which nothing was
// measured.
glm::dvec3 mean_coordinate_miss(std::span<const CoordinateRow> coordinates,
                                const BundleState& state);

// Points of which all three coordinates were measured.
std::map<int, glm::dvec3> surveyed_places(std::span<const CoordinateRow> coordinates);

// Least squares over one or more pairs.
RigidTransform fit_body(std::span<const glm::dvec3> in_body, std::span<const glm::dvec3> in_world);

}  // namespace bosk
