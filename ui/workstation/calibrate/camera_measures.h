#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

// A camera in numbers that a person can check.
struct CameraMeasures {
  std::string name;
  double focal_px = 0.0;   // mean of both axes
  std::string lens;        // "pinhole", "OpenCV, k1 -0.061"
  double distance = 0.0;   // to what all cameras look at; metres, as far as the world is in metres
  double height = 0.0;     // of the eye over the world's ground
  double pitch_deg = 0.0;  // of its axis: upwards is positive
};
CameraMeasures measures_of(const Camera& camera, const glm::dvec3& middle);

// The direction in the world that is up in the photo when it is shown upright; unit length.
glm::dvec3 up_in_world(const Camera& camera, int exif_orientation);

// Whether the world's z axis points where the photos say that up is.
enum class UpVerdict { up, down, sideways, unknown };
// By the mean over all cameras; unknown without any.
UpVerdict up_verdict(std::span<const Camera> cameras,
                     const std::function<int(const std::string& name)>& orientation_of);
std::string words_of(UpVerdict verdict);

// "22 of 24 photos have a camera; without: IMG_07, IMG_12", of the latter at most six by name.
std::string match_words(std::size_t matched, const std::vector<std::string>& unmatched);

}  // namespace bosk
