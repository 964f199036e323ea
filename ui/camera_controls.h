#pragma once

#include <glm/glm.hpp>

#include "core/photo/camera.h"
#include "core/render/terrain.h"

namespace bosk {

// How a person moves through a forest: functions from one place of the eye to the next.
struct ViewCamera {
  enum class Mode {
    orbit,  // around a target that stays in the middle of the picture
    fly,    // where one looks, through the air
    walk,   // on the ground, eyes at kEyeHeight
  } mode = Mode::orbit;
  glm::dvec3 eye{0.0, -10.0, 1.7};
  double heading = 1.5707963267948966;  // radians, from east (+x) towards north (+y)
  double pitch = 0.0;                   // radians, upwards; within kSteepest of level
  double distance = 10.0;               // from the eye to the target of an orbit, metres
  double speed = 4.0;                   // of flying and walking, metres a second

  bool operator==(const ViewCamera&) const = default;
};
inline constexpr double kEyeHeight = 1.7;   // metres
inline constexpr double kSteepest = 1.553;  // radians: 89 degrees
inline constexpr double kClearance = 0.05;  // metres that an eye keeps above the ground

glm::dvec3 forward_of(const ViewCamera& view);  // unit length
glm::dvec3 target_of(const ViewCamera& view);

// At `eye`, with `at` as the target. Eye and target in one place look north.
ViewCamera looking_at(const ViewCamera& view, const glm::dvec3& eye, const glm::dvec3& at);

// The mouse moved by `delta_px` (x right, y down) in a picture `height_px` high. Orbit: the
// scene follows the mouse, half a turn over the picture's height; else the head turns.
ViewCamera dragged(const ViewCamera& view, const glm::dvec2& delta_px, double height_px,
                   const Terrain& terrain);
// The same with the button that moves: what lies at the target's distance follows the mouse.
ViewCamera panned(const ViewCamera& view, const glm::dvec2& delta_px, double height_px,
                  double view_angle, const Terrain& terrain);
// The wheel, steps towards the picture being positive. Orbit: nearer; else faster.
ViewCamera zoomed(const ViewCamera& view, double steps, const Terrain& terrain);

// The eye walked round its target by an angle, counterclockwise seen from above, at the same
// height.
ViewCamera walked_round(const ViewCamera& view, double angle, const Terrain& terrain);

// Keys held down: -1 to 1 along each axis of the eye; `up` is along +z.
struct Strides {
  double forward = 0.0, right = 0.0, up = 0.0;
  bool fast = false;  // four times as fast
};
bool is_moving(const Strides& strides);
// After `seconds` of it. An orbit takes its target along, and moves a target's distance in 2 s.
ViewCamera moved(const ViewCamera& view, const Strides& strides, double seconds,
                 const Terrain& terrain);

// The eye stays where it is, but a walker comes down to the ground and looks level.
ViewCamera switched(const ViewCamera& view, ViewCamera::Mode mode, const Terrain& terrain);

// A pinhole; `view_angle` is that of the picture's height, radians.
Camera camera_of(const ViewCamera& view, const glm::ivec2& size_px, double view_angle);

}  // namespace bosk
