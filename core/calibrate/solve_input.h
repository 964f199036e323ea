#pragma once

#include <string>
#include <vector>

#include "core/calibrate/bundle.h"
#include "core/calibrate/seed.h"
#include "core/calibrate/solve.h"

namespace bosk {

// What solve_cameras works on: the photos and points that can be used, by index.
struct SolveInput {
  std::vector<std::size_t> photo_of_camera;  // among the photos as given
  std::vector<std::string> points;           // names
  std::vector<std::string> bodies;           // names
  BundleProblem problem;                     // its rows hold what was measured
  std::vector<std::string> refused;          // of each photo as given: why it isn't used; or empty
  std::vector<std::string> sentences;        // what of the survey can't be used
  Lens lens;

  std::size_t cameras() const { return photo_of_camera.size(); }
};

// Throws Error as solve_cameras does.
void check_input(std::span<const PhotoSightings> photos, const Survey& survey,
                 const LensKnowledge& lens);

// Leaves out photos of another size than the lens's (or, without one, than most), copies of another
// photo, those already `refused`, and, until nothing changes, points that only one photo sees and
// photos with fewer sightings than are needed.
SolveInput solve_input(std::span<const PhotoSightings> photos, const Survey& survey,
                       const LensKnowledge& lens, const SolveOptions& options,
                       std::vector<std::string> refused);

std::vector<SeedBody> seed_bodies(const SolveInput& input);

}  // namespace bosk
