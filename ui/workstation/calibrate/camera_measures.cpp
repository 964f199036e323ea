#include "ui/workstation/calibrate/camera_measures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_access.hpp>
#include <numbers>

#include "core/image/orientation.h"

namespace bosk {
namespace {

constexpr std::size_t kMostNames = 6;

std::string lens_words(const Lens& lens) {
  if (lens.model == LensModel::pinhole) return "pinhole";
  char text[64];
  const char* name = lens.model == LensModel::opencv ? "OpenCV" : "OpenCV fisheye";
  std::snprintf(text, sizeof text, "%s, k1 %.3g", name, lens.distortion[0]);
  return text;
}

}  // namespace

CameraMeasures measures_of(const Camera& camera, const glm::dvec3& middle) {
  const glm::dvec3 centre = camera.centre_in_world();
  const glm::dvec3 axis = glm::row(camera.camera_from_world.rotation, 2);
  CameraMeasures measures;
  measures.name = camera.name;
  measures.focal_px = 0.5 * (camera.lens.focal_px.x + camera.lens.focal_px.y);
  measures.lens = lens_words(camera.lens);
  measures.distance = glm::distance(centre, middle);
  measures.height = centre.z;
  measures.pitch_deg = std::asin(std::clamp(axis.z, -1.0, 1.0)) * 180.0 / std::numbers::pi;
  return measures;
}

glm::dvec3 up_in_world(const Camera& camera, int exif_orientation) {
  const glm::ivec2 size(2, 2);
  const glm::dvec2 up_in_picture = pixel_from_upright({0.0, 0.0}, size, exif_orientation) -
                                   pixel_from_upright({0.0, 1.0}, size, exif_orientation);
  return inverse(camera.camera_from_world).rotation * glm::dvec3(up_in_picture, 0.0);
}

UpVerdict up_verdict(std::span<const Camera> cameras,
                     const std::function<int(const std::string& name)>& orientation_of) {
  if (cameras.empty()) return UpVerdict::unknown;
  double along_z = 0.0;
  for (const Camera& camera : cameras) {
    along_z += up_in_world(camera, orientation_of(camera.name)).z;
  }
  along_z /= double(cameras.size());
  // Half: photos look up or down by less than 60 degrees on the whole
  if (along_z > 0.5) return UpVerdict::up;
  return along_z < -0.5 ? UpVerdict::down : UpVerdict::sideways;
}

std::string words_of(UpVerdict verdict) {
  const std::string remedy =
      "; Bosk takes z as up: give cameras of a world that stands upright (COLMAP: "
      "model_orientation_aligner)";
  switch (verdict) {
    case UpVerdict::up:
      return "Up is up: the z axis points where the photos' upper edges do.";
    case UpVerdict::down:
      return "The world stands on its head: its z axis points down in the photos" + remedy + ".";
    case UpVerdict::sideways:
      return "The world lies on its side: its z axis doesn't point up in the photos" + remedy + ".";
    case UpVerdict::unknown:
      break;
  }
  return {};
}

std::string match_words(std::size_t matched, const std::vector<std::string>& unmatched) {
  const std::size_t all = matched + unmatched.size();
  std::string words = std::to_string(matched) + " of " + std::to_string(all) +
                      (all == 1 ? " photo has" : " photos have") + " a camera";
  for (std::size_t i = 0; i < std::min(kMostNames, unmatched.size()); ++i) {
    words += (i == 0 ? "; without: " : ", ") + unmatched[i];
  }
  if (unmatched.size() > kMostNames) {
    words += " and " + std::to_string(unmatched.size() - kMostNames) + " more";
  }
  return words;
}

}  // namespace bosk
