#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/photo/camera.h"

namespace bosk {

// A look at cameras from outside: around a target, also from below.
struct OrbitView {
  glm::dvec3 target{0.0};
  double heading = -1.0;   // radians; where the eye is, from the world's x axis towards y
  double elevation = 0.4;  // radians; of the eye, at most kSteepestOrbit either way
  double distance = 10.0;  // from eye to target

  bool operator==(const OrbitView&) const = default;
};
inline constexpr double kSteepestOrbit = 1.553;  // 89 degrees
inline constexpr double kOrbitViewAngle = 0.7;   // of the picture's height, radians

glm::dvec3 eye_of(const OrbitView& view);
// The scene follows the mouse, half a turn over the picture's height.
OrbitView turned(const OrbitView& view, const glm::dvec2& delta_px, double height_px);
// What lies at the target's distance follows the mouse.
OrbitView moved(const OrbitView& view, const glm::dvec2& delta_px, double height_px);
// Steps of the wheel; positive: nearer.
OrbitView nearer(const OrbitView& view, double steps);
// All cameras and what they look at.
OrbitView overview_of(std::span<const Camera> cameras, const glm::dvec3& middle);
// A pinhole that shows it in a picture of this size.
Camera camera_of(const OrbitView& view, const glm::dvec2& size_px);
// The look through one of the cameras, all of its picture in a picture of this size. Its lens bends
// nothing here.
Camera camera_through(const Camera& camera, const glm::dvec2& size_px);

// What a camera sees, up to its picture at some distance.
struct Frustum {
  std::string name;
  glm::dvec3 eye{0.0};
  // Of the picture as delivered, clockwise from its first pixel.
  std::array<glm::dvec3, 4> corners{};

  glm::dvec3 middle() const { return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]); }
  // 0 to 1 across and down the picture.
  glm::dvec3 at(double across, double down) const;
};
// `depth` is along the camera's axis.
Frustum frustum_of(const Camera& camera, double depth);
// So that pictures of cameras around a tree neither vanish nor hide each other.
double frustum_depth(std::span<const Camera> cameras, const glm::dvec3& middle);
// Indices of the frusta, the farthest from the eye first.
std::vector<std::size_t> back_to_front(std::span<const Frustum> frusta, const glm::dvec3& eye);

// Where a line is seen by a pinhole, without what lies behind it; none where all does.
std::optional<std::pair<glm::dvec2, glm::dvec2>> seen_line(const Camera& pinhole,
                                                           const glm::dvec3& from,
                                                           const glm::dvec3& to);
// Where a quadrangle is seen; none where a corner lies behind the camera.
std::optional<std::array<glm::dvec2, 4>> seen_quad(const Camera& pinhole,
                                                   const std::array<glm::dvec3, 4>& corners);
// Whether the place lies in the quadrangle, whichever way round it goes.
bool is_inside(const std::array<glm::dvec2, 4>& quad, const glm::dvec2& place);

// The edge of a square of the ground's grid: 1, 2 or 5 times a power of ten, about a tenth of the
// view's width.
double grid_step(double view_width);

}  // namespace bosk
