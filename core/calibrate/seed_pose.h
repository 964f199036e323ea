#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace bosk {

// A point whose place is known, seen along a direction.
struct PoseSighting {
  glm::dvec3 in_world{0.0};
  glm::dvec3 bearing{0.0};  // in the camera, of unit length
  double sigma = 1e-3;      // radians
};

struct PlacedPose {
  RigidTransform camera_from_world;
  double cost = 0.0;  // as in bundle.h
};

// All poses that triples of the sightings suggest (P3P of Ke and Roumeliotis 2017), refined on all
// sightings with the loss of bundle.h; each once, lowest cost first. Empty with fewer than four
// sightings or all points on a line. The order of the sightings decides which of many triples are
// tried.
std::vector<PlacedPose> place_camera(std::span<const PoseSighting> sightings, double loss_scale);

// As above, from a pose to begin with.
PlacedPose refined_pose(std::span<const PoseSighting> sightings, const RigidTransform& start,
                        double loss_scale);

}  // namespace bosk
