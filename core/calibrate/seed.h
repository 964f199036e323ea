#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/seed_scene.h"

namespace bosk {

// A first guess of all cameras and points, in a frame and scale of its own, and where it came from.
struct Seed {
  std::string from;  // "orbit of +1.0 turns", "photos 3 and 5"
  PartialScene scene;
};

// A body of known shape, as indices of points.
struct SeedBody {
  std::vector<int> points;
  std::vector<glm::dvec3> in_body;
};

// Cameras on a circle round the middle of what they see, evenly spaced in the photos' order: once
// round, half round, three quarters and twice, both ways each.
std::vector<Seed> orbit_seeds(const SeedScene& scene);
// Two photos that see many common points (five-point algorithm of Nister 2004, by OpenCV), then the
// others one by one.
std::vector<Seed> pair_seeds(const SeedScene& scene, std::size_t most, const Progress& progress);
// From the photos that see four points of a body, then the others one by one.
std::vector<Seed> body_seeds(const SeedScene& scene, const std::vector<SeedBody>& bodies,
                             const Progress& progress);

}  // namespace bosk
