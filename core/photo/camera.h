#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/rigid_transform.h"

namespace bosk {

// How a lens bends rays, in OpenCV's formulas (calib3d, and fisheye for the last). Parameters that a
// model doesn't use are zero.
enum class LensModel {
  pinhole,         // none
  opencv,          // k1 k2 p1 p2 k3 [k4 k5 k6]: also COLMAP's SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV
  opencv_fisheye,  // k1 k2 k3 k4
};

// Intrinsics of one lens and sensor size. Pixel (0, 0) is the centre of the top-left pixel, so a
// COLMAP or transforms.json principal point is larger by 0.5.
struct Lens {
  LensModel model = LensModel::pinhole;
  int width_px = 0, height_px = 0;
  glm::dvec2 focal_px{0.0};
  glm::dvec2 principal_px{0.0};
  std::array<double, 8> distortion{};  // opencv: k1 k2 p1 p2 k3 k4 k5 k6; fisheye: k1 k2 k3 k4

  bool operator==(const Lens&) const = default;
};

struct Camera {
  std::string name;  // of the photo, without folder and ending; files match photos by it
  Lens lens;
  RigidTransform camera_from_world;  // x right, y down, z forward

  glm::dvec3 centre_in_world() const { return inverse(camera_from_world).translation; }
};

// Where the point is seen; none behind the camera or where the lens model folds over (the distorted
// radius no longer grows with the true one).
std::optional<glm::dvec2> pixel_from_camera(const Lens& lens, const glm::dvec3& point_in_camera);
std::optional<glm::dvec2> project(const Camera& camera, const glm::dvec3& point_in_world);

// Direction of unit length, in the camera's frame, that is seen at the pixel; none where the lens
// model has no answer. Inverse of pixel_from_camera to 1e-9 px.
std::optional<glm::dvec3> camera_from_pixel(const Lens& lens, const glm::dvec2& pixel);
// The ray through the pixel, in the world.
std::optional<Ray> world_ray(const Camera& camera, const glm::dvec2& pixel);

// The same lens for an image scaled to another size; distortion is unchanged.
Lens scaled(const Lens& lens, int width_px, int height_px);
// The pinhole lens that the undistorted photo has: same size, focal length and principal point.
Lens undistorted(const Lens& lens);

}  // namespace bosk
