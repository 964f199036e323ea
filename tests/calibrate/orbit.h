#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/calibrate/sightings.h"
#include "core/calibrate/survey.h"
#include "core/photo/camera.h"

namespace bosk {

// A walk round markers with known truth, for tests and the benchmark.
struct OrbitOptions {
  std::uint64_t seed = 1;
  int photos = 24, markers = 8;
  double radius_m = 7.0, eye_m = 1.6;
  double turns = 1.0;            // share of a full walk; below 0 the other way
  double jitter_deg = 3.0;       // of the azimuth, uniform to either side
  double radius_jitter = 0.1;    // relative, uniform
  double second_height_m = 0.0;  // of every second photo's eye; 0: all at one height
  double noise_px = 0.5, gross = 0.05, missing = 0.25;
  int fewest_sightings = 5;   // that `missing` leaves in a photo
  bool feet = false;          // sticks' lower ends are marked too
  double distortion = -0.06;  // k1
  double focal_px = 3030.0;   // of photos 4032 wide
};

struct Orbit {
  Lens lens;
  std::vector<Camera> cameras;
  std::vector<std::string> names;  // of the points
  std::vector<glm::dvec3> points;
  std::vector<PhotoSightings> photos;

  const glm::dvec3& place(const std::string& name) const;
};

Orbit make_orbit(const OrbitOptions& options);
// The points as photo `camera` would sight them, without noise.
PhotoSightings exact_sightings(const Orbit& orbit, const Camera& camera);
std::string orbit_photo_name(int index);

Tape exact_tape(const Orbit& orbit, const std::string& from, const std::string& to);
std::vector<Height> exact_heights(const Orbit& orbit);

// The lens that a person would guess: no distortion, the axis in the middle.
Lens guessed_orbit_lens(const Orbit& orbit, double focal_ratio = 1.0);

// Errors of a calibration against the truth: markers after the similarity that fits them best, the
// crown after that of cameras and markers together.
struct OrbitErrors {
  double marker_rms_m = 0.0, marker_median_m = 0.0;
  double worst_crown_px = 0.0, crown_rms_px = 0.0;  // over cameras whose photo counts as placed
  std::vector<double> crown_px;                     // of each of calibration.cameras
  double scale_error = 0.0;                         // relative
};
OrbitErrors orbit_errors(const Orbit& orbit, const Calibration& calibration);

const PhotoFinding& finding_of(const Calibration& calibration, const std::string& photo);
// All sentences, a line each.
std::string sentences_of(const Calibration& calibration);

}  // namespace bosk
