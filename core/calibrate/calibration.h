#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

enum class PhotoFate : std::uint8_t {
  placed,     // its camera is in the result
  uncertain,  // placed, but its finding says why to look at it
  refused,    // not placed: too few points, or it disagrees with the others
};

// What calibration found out about one photo.
struct PhotoFinding {
  std::string photo;
  PhotoFate fate = PhotoFate::placed;
  std::string reason;  // a clause, with the remedy; empty for a photo that is well placed
  int sightings = 0, outliers = 0;
  double rms_px = 0.0;          // over both axes, outliers left out
  double crown_sigma_px = 0.0;  // the pose's uncertainty as seen at the crown, one sigma, in pixels
  glm::dmat3 centre_covariance_m2{0.0};
};

struct SightingResidual {
  std::string photo, point;
  glm::dvec2 pixel{0.0}, error_px{0.0};  // seen; predicted minus seen
  bool outlier = false;
};

struct SolvedPoint {
  std::string name;
  glm::dvec3 in_world{0.0};
  glm::dmat3 covariance_m2{0.0};
  int photos = 0;
  double rms_px = 0.0;
};

enum class Verdict : std::uint8_t {
  good,     // accurate enough for every later stage
  usable,   // later stages run; the sentences say what would make it better
  refused,  // no cameras are given
};

// Cameras in the world of the project: +z up, metres when `scale_known`, else in units of the mean
// distance from cameras to the trunk. `sentences` explain the verdict, most important first; each
// names what is wrong and what to do.
struct Calibration {
  Verdict verdict = Verdict::refused;
  std::vector<std::string> sentences;
  Lens lens;
  bool lens_was_known = false;
  std::vector<Camera> cameras;       // of the photos that were placed, by name
  std::vector<PhotoFinding> photos;  // every photo, by name
  std::vector<SolvedPoint> points;
  std::vector<SightingResidual> residuals;
  bool scale_known = false, up_known = false;
  double scale_sigma = 0.0;  // relative, one sigma; 0 while the scale isn't known
  double rms_px = 0.0;
};

}  // namespace bosk
