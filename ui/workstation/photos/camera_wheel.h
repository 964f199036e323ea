#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

// The point that all cameras look at, nearly: the one nearest to their axes by least squares. The
// world's origin where the axes don't tell (fewer than two, or all parallel).
glm::dvec3 middle_of(std::span<const Camera> cameras);

// Cameras as seen from above; angles in radians, counterclockwise from the world's x axis.
struct WheelSpoke {
  std::string name;
  glm::dvec2 place_m{0.0};     // from the middle
  glm::dvec2 looks{1.0, 0.0};  // unit length; where it looks, without up and down
  double angle = 0.0;          // of its place, 0 to 2 pi
};
// Between two neighbours nobody took a photo.
struct WheelGap {
  std::string from, to;  // names of the photos at its ends, counterclockwise
  double start = 0.0;    // angle of `from`
  double size = 0.0;     // up to 2 pi, for a single camera
};
struct CameraWheel {
  std::vector<WheelSpoke> spokes;  // by angle
  std::vector<WheelGap> gaps;      // one behind each spoke
  double radius_m = 1.0;           // of the farthest spoke, positive
};
CameraWheel wheel_of(std::span<const Camera> cameras, const glm::dvec3& middle);

inline constexpr double kWideGap = 0.7853981633974483;  // 45 degrees: from here on it shows
// The first of the widest; none without cameras.
std::optional<WheelGap> widest_gap(const CameraWheel& wheel);
// "24 photos; the widest gap is 18 degrees, from IMG_03 to IMG_04".
std::string words_of(const CameraWheel& wheel);

}  // namespace bosk
