#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace bosk {

enum class SightedBy : std::uint8_t { click, ball, tag, board, feature };

// Where a named point of the scene is seen in a photo.
struct Sighting {
  std::string point;      // "red", "tag36h11 12/3", "board 4,2", or as a person named it
  glm::dvec2 pixel{0.0};  // of the photo as delivered: not scaled, not undistorted
  double sigma_px = 0.5;  // standard deviation along each axis, > 0
  SightedBy by = SightedBy::click;
};

// All that calibration takes from one photo.
struct PhotoSightings {
  std::string photo;  // its name
  int width_px = 0, height_px = 0;
  std::optional<double> exif_focal_px;     // as EXIF says, which may lie
  std::optional<glm::dvec3> up_in_camera;  // of unit length, where the photo's gravity is known
  std::vector<Sighting> sightings;         // at most one of each point
};

}  // namespace bosk
