#pragma once

#include <glm/glm.hpp>

#include "core/photo/camera.h"

namespace bosk {

// The one place where our camera (x right, y down, z forward) meets OpenGL's (x right, y up, z
// backwards).
inline const glm::dmat4 gl_camera_from_camera{1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};

// Depth of everything that is drawn: a point at depth z (metres along the viewing direction) has
// normalised device depth 1 - 2 kNear_m / z, from -1 at kNear_m to 1 infinitely far; in the depth
// buffer 1 - kNear_m / z. A floating-point buffer tells apart 1 m at 1300 m, 1 cm at 130 m.
inline constexpr double kNear_m = 0.1;

// Clip coordinates of points in our camera's frame, for scenery drawn by matrices: the lens without
// its distortion, the depth above. The picture's top row is the framebuffer's highest.
glm::dmat4 gl_clip_from_camera(const Lens& lens);

// Where the lens model folds over, as shaders need it: the square of the undistorted radius
// (LensModel::opencv, tangential part left aside) or the angle from the axis (opencv_fisheye). Huge
// where it never does.
double lens_fold(const Lens& lens);

// Whether the lens only scales and shifts.
bool is_undistorted(const Lens& lens);

}  // namespace bosk
