#include "core/render/gl/gl_camera.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

constexpr double kNoFold = 1e16;  // pixel_from_camera's own limit of the squared radius

// Largest value up to which `seen` holds, which is true near zero and false from some value on.
template <class Seen>
double last_seen(double low, double high, const Seen& seen) {
  if (seen(high)) return high;
  for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
    // Far apart the values are halved in their exponents
    const double middle = high > 4.0 * low ? std::sqrt(low * high) : 0.5 * (low + high);
    (seen(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

glm::dmat4 gl_clip_from_camera(const Lens& lens) {
  const glm::dvec2 size_px(lens.width_px, lens.height_px);
  const glm::dvec2 scale = 2.0 * lens.focal_px / size_px;
  const glm::dvec2 shift = 2.0 * (lens.principal_px + 0.5) / size_px - 1.0;
  glm::dmat4 clip_from_camera(0.0);
  clip_from_camera[0][0] = scale.x;
  clip_from_camera[1][1] = -scale.y;
  clip_from_camera[2] = {shift.x, -shift.y, 1.0, 1.0};
  clip_from_camera[3][2] = -2.0 * kNear_m;
  return clip_from_camera;
}

bool is_undistorted(const Lens& lens) {
  if (lens.model == LensModel::pinhole) return true;
  return lens.model == LensModel::opencv &&
         std::all_of(lens.distortion.begin(), lens.distortion.end(),
                     [](double k) { return k == 0.0; });
}

double lens_fold(const Lens& lens) {
  if (is_undistorted(lens)) return kNoFold;
  Lens radial = lens;
  if (lens.model == LensModel::opencv_fisheye) {
    return last_seen(1e-9, 1.5707963, [&](double angle) {
      return pixel_from_camera(radial, {std::sin(angle), 0.0, std::cos(angle)}).has_value();
    });
  }
  radial.distortion[2] = radial.distortion[3] = 0.0;
  return last_seen(1e-18, 0.999 * kNoFold, [&](double radius_squared) {
    return pixel_from_camera(radial, {std::sqrt(radius_squared), 0.0, 1.0}).has_value();
  });
}

}  // namespace bosk
