#include "core/photo/camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace bosk {
namespace {

using glm::dmat2;
using glm::dvec2;
using glm::dvec3;

constexpr double kInverseError_px = 1e-10;  // a tenth of what camera.h promises
constexpr double kRounding =
    1e-14;  // a step as small, relatively, is noise: x is as good as it gets
constexpr double kHalfPi = 1.57079632679489661923;

// Bernstein coefficient j of degree N - 1 is the sum of these times the terms i of the power
// series.
template <std::size_t N>
constexpr std::array<std::array<double, N>, N> bernstein_from_powers() {
  std::array<std::array<double, N>, N> share{};
  for (std::size_t j = 0; j < N; ++j) {
    share[j][0] = 1.0;  // (j over i) / (N - 1 over i)
    for (std::size_t i = 1; i <= j; ++i)
      share[j][i] = share[j][i - 1] * double(j - i + 1) / double(N - i);
  }
  return share;
}

// Whether a polynomial on [0, 1], given by its Bernstein coefficients, stays above zero: so it does
// when they all are; otherwise both halves are asked (de Casteljau).
template <std::size_t N>
bool stays_positive(std::array<double, N> bernstein, int depth) {
  if (std::all_of(bernstein.begin(), bernstein.end(), [](double b) { return b > 0.0; }))
    return true;
  if (!(bernstein.front() > 0.0) || !(bernstein.back() > 0.0) || depth == 0) return false;
  std::array<double, N> right{};
  for (std::size_t level = 0; level < N; ++level) {
    right[N - 1 - level] = bernstein[N - 1];
    for (std::size_t i = N - 1; i > level; --i)
      bernstein[i] = 0.5 * (bernstein[i - 1] + bernstein[i]);
  }
  return stays_positive(bernstein, depth - 1) && stays_positive(right, depth - 1);
}

// Whether sum c[i] s^i > 0 for all s from 0 to `end`. Exact up to rounding; a polynomial that
// touches zero counts as not positive.
template <std::size_t N>
bool positive_up_to(double end, const std::array<double, N>& coefficients) {
  std::array<double, N> term{};
  double power = 1.0, lower_bound = 0.0;
  for (std::size_t i = 0; i < N; ++i, power *= end) {
    term[i] = coefficients[i] * power;
    lower_bound += i == 0 ? term[i] : std::min(term[i], 0.0);
  }
  if (lower_bound > 0.0) return true;
  constexpr auto share = bernstein_from_powers<N>();
  std::array<double, N> bernstein{};
  for (std::size_t j = 0; j < N; ++j)
    for (std::size_t i = 0; i <= j; ++i) bernstein[j] += share[j][i] * term[i];
  return stays_positive(bernstein, 40);
}

// What the lens makes of an undistorted value: a normalised image point, or an angle from the axis.
template <class T, class Slope>
struct Bent {
  bool inside = false;  // of the model's domain; else the rest says nothing
  T value{};
  Slope slope{};  // derivative of `value` by the undistorted one
};
using BentPoint = Bent<dvec2, dmat2>;
using BentAngle = Bent<double, double>;

struct Radial {
  std::array<double, 4> over, under;  // coefficients of r^0, r^2, r^4, r^6
};

Radial radial_part(const Lens& lens) {
  const auto& k = lens.distortion;
  return {{1.0, k[0], k[1], k[4]}, {1.0, k[5], k[6], k[7]}};
}

// Whether the distorted radius r over(r^2) / under(r^2) grows all the way from the axis to r. The
// sign of its derivative is that of sum over[i] under[j] (1 + 2i - 2j) r^(2i + 2j).
bool before_fold(const Lens& lens, double radius_squared) {
  const Radial radial = radial_part(lens);
  std::array<double, 7> growth{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      growth[i + j] += radial.over[i] * radial.under[j] * (1.0 + 2.0 * double(i) - 2.0 * double(j));
  return positive_up_to(radius_squared, radial.under) && positive_up_to(radius_squared, growth);
}

// OpenCV's model with rational radial and tangential part: calib3d, "Camera Calibration and 3D
// Reconstruction", without its thin prism and tilt. None beyond the fold.
BentPoint bend_opencv(const Lens& lens, const dvec2& point) {
  const double r2 = glm::dot(point, point);
  if (!(r2 < 1e16) || !before_fold(lens, r2)) return {};
  const auto [over_k, under_k] = radial_part(lens);
  const double p1 = lens.distortion[2], p2 = lens.distortion[3], x = point.x, y = point.y;
  const double over = 1.0 + r2 * (over_k[1] + r2 * (over_k[2] + r2 * over_k[3]));
  const double under = 1.0 + r2 * (under_k[1] + r2 * (under_k[2] + r2 * under_k[3]));
  const double over_slope = over_k[1] + r2 * (2.0 * over_k[2] + r2 * 3.0 * over_k[3]);
  const double under_slope = under_k[1] + r2 * (2.0 * under_k[2] + r2 * 3.0 * under_k[3]);
  const double factor = over / under;
  const double slope = (over_slope - factor * under_slope) / under;  // by r^2
  const dvec2 shift(2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
                    p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y);
  const double across = 2.0 * slope * x * y + 2.0 * p1 * x + 2.0 * p2 * y;
  const dmat2 derivative(factor + 2.0 * slope * x * x + 2.0 * p1 * y + 6.0 * p2 * x, across, across,
                         factor + 2.0 * slope * y * y + 6.0 * p1 * y + 2.0 * p2 * x);
  // The tangential part can fold the image too, far from the axis.
  if (!(glm::determinant(derivative) > 0.0)) return {};
  return {true, factor * point + shift, derivative};
}

// OpenCV's fisheye model: the distance from the image centre as a polynomial of the angle from the
// axis.
BentAngle bend_fisheye(const Lens& lens, double angle) {
  const auto& k = lens.distortion;
  const double a2 = angle * angle;
  if (!positive_up_to(a2, std::array{1.0, 3.0 * k[0], 5.0 * k[1], 7.0 * k[2], 9.0 * k[3]}))
    return {};
  const double factor = 1.0 + a2 * (k[0] + a2 * (k[1] + a2 * (k[2] + a2 * k[3])));
  const double derivative =
      1.0 + a2 * (3.0 * k[0] + a2 * (5.0 * k[1] + a2 * (7.0 * k[2] + a2 * 9.0 * k[3])));
  return {true, angle * factor, derivative};
}

bool is_straight(const Lens& lens) {
  if (lens.model == LensModel::pinhole) return true;
  return lens.model == LensModel::opencv &&
         std::all_of(lens.distortion.begin(), lens.distortion.end(),
                     [](double k) { return k == 0.0; });
}

std::optional<dvec2> bent_from_camera(const Lens& lens, const dvec3& point) {
  const dvec2 straight = dvec2(point) / point.z;
  if (is_straight(lens)) return straight;
  if (lens.model == LensModel::opencv) {
    const BentPoint bent = bend_opencv(lens, straight);
    return bent.inside ? std::optional(bent.value) : std::nullopt;
  }
  const double radius = glm::length(dvec2(point));
  const BentAngle bent = bend_fisheye(lens, std::atan2(radius, point.z));
  if (!bent.inside) return std::nullopt;
  return radius > 0.0 ? bent.value / radius * dvec2(point) : dvec2(0.0);
}

double size_of(double value) { return std::abs(value); }
double size_of(const dvec2& value) { return glm::length(value); }

dvec2 newton_step(const dmat2& slope, const dvec2& miss) { return glm::inverse(slope) * miss; }
double newton_step(double slope, double miss) { return miss / slope; }

// Solves bend(x) = target by Newton's method from `x`. A step that leaves the model's domain or
// doesn't come nearer is halved, so a radius that grows is always inverted; a target beyond the
// fold ends with none.
template <class T, class Bend>
std::optional<T> unbend(const T& target, T x, double tolerance, const Bend& bend) {
  auto here = bend(x);
  for (int i = 0; i < 60 && !here.inside; ++i) here = bend(x = 0.5 * x);
  for (int i = 0, stuck = 0; i < 100 && here.inside && stuck < 8; ++i) {
    const T miss = target - here.value;
    if (size_of(miss) <= tolerance) return x;
    const T full_step = newton_step(here.slope, miss);
    T step = full_step;
    const auto nearer = [&](const auto& there) {
      return there.inside && size_of(target - there.value) < size_of(miss);
    };
    auto there = bend(x + step);
    for (int halving = 0; halving < 40 && !nearer(there); ++halving)
      there = bend(x + (step = 0.5 * step));
    if (!nearer(there))
      return size_of(full_step) < kRounding * size_of(x) ? std::optional(x) : std::nullopt;
    if (size_of(target - there.value) > 0.9 * size_of(miss)) ++stuck;  // at the fold
    x = x + step;
    here = there;
  }
  return std::nullopt;
}

std::optional<dvec3> camera_from_bent_opencv(const Lens& lens, const dvec2& bent,
                                             double tolerance) {
  const auto bend = [&lens](const dvec2& x) { return bend_opencv(lens, x); };
  const std::optional<dvec2> straight = unbend(bent, bent, tolerance, bend);
  if (!straight) return std::nullopt;
  return glm::normalize(dvec3(*straight, 1.0));
}

std::optional<dvec3> camera_from_bent_fisheye(const Lens& lens, const dvec2& bent,
                                              double tolerance) {
  const double radius = glm::length(bent);
  if (radius == 0.0) return dvec3(0.0, 0.0, 1.0);
  const auto bend = [&lens](double angle) { return bend_fisheye(lens, angle); };
  const std::optional<double> angle = unbend(radius, std::min(radius, kHalfPi), tolerance, bend);
  if (!angle || !(*angle < kHalfPi)) return std::nullopt;  // behind the camera
  return dvec3(std::sin(*angle) / radius * bent, std::cos(*angle));
}

bool finite(const dvec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

}  // namespace

std::optional<dvec2> pixel_from_camera(const Lens& lens, const dvec3& point_in_camera) {
  if (!(point_in_camera.z > 0.0)) return std::nullopt;
  const std::optional<dvec2> bent = bent_from_camera(lens, point_in_camera);
  if (!bent) return std::nullopt;
  const dvec2 pixel = lens.focal_px * *bent + lens.principal_px;
  return finite(pixel) ? std::optional(pixel) : std::nullopt;
}

std::optional<dvec2> project(const Camera& camera, const dvec3& point_in_world) {
  return pixel_from_camera(camera.lens, camera.camera_from_world * point_in_world);
}

std::optional<dvec3> camera_from_pixel(const Lens& lens, const dvec2& pixel) {
  const dvec2 bent = (pixel - lens.principal_px) / lens.focal_px;
  if (!finite(bent)) return std::nullopt;
  if (is_straight(lens)) return glm::normalize(dvec3(bent, 1.0));
  const double focal_px = std::max(lens.focal_px.x, lens.focal_px.y);
  const double tolerance = kInverseError_px / focal_px + 1e-15 * glm::length(bent);
  if (lens.model == LensModel::opencv) return camera_from_bent_opencv(lens, bent, tolerance);
  return camera_from_bent_fisheye(lens, bent, tolerance);
}

std::optional<Ray> world_ray(const Camera& camera, const dvec2& pixel) {
  const std::optional<dvec3> direction = camera_from_pixel(camera.lens, pixel);
  if (!direction) return std::nullopt;
  const RigidTransform world_from_camera = inverse(camera.camera_from_world);
  return Ray{world_from_camera.translation, world_from_camera.rotation * *direction};
}

Lens scaled(const Lens& lens, int width_px, int height_px) {
  assert(lens.width_px > 0 && lens.height_px > 0);
  const dvec2 scale = dvec2(width_px, height_px) / dvec2(lens.width_px, lens.height_px);
  Lens result = lens;
  result.width_px = width_px;
  result.height_px = height_px;
  result.focal_px = lens.focal_px * scale;
  result.principal_px = (lens.principal_px + 0.5) * scale - 0.5;
  return result;
}

Lens undistorted(const Lens& lens) {
  Lens result = lens;
  result.model = LensModel::pinhole;
  result.distortion = {};
  return result;
}

}  // namespace bosk
