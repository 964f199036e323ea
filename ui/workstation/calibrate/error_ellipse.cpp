#include "ui/workstation/calibrate/error_ellipse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/project/calibration_figures.h"

namespace bosk {
namespace {

constexpr int kOutlinePoints = 40;
constexpr double kNear = 1e-3;

// Along x and y of the camera's frame, which is where the picture's axes point.
glm::dmat2 spread_in_picture(const Camera& pinhole, const glm::dvec3& in_camera,
                             const glm::dmat3& covariance_m2) {
  const glm::dmat3& turn = pinhole.camera_from_world.rotation;
  const glm::dmat3 c = turn * covariance_m2 * glm::transpose(turn);
  const glm::dvec2 f = pinhole.lens.focal_px / in_camera.z;
  // Rows of the projection's derivative
  const glm::dvec3 rows[] = {{f.x, 0.0, -f.x * in_camera.x / in_camera.z},
                             {0.0, f.y, -f.y * in_camera.y / in_camera.z}};
  const double xy = glm::dot(rows[0], c * rows[1]);
  return {glm::dot(rows[0], c * rows[0]), xy, xy, glm::dot(rows[1], c * rows[1])};
}

}  // namespace

std::optional<std::vector<glm::dvec2>> seen_ellipse(const Camera& pinhole,
                                                    const glm::dvec3& in_world,
                                                    const glm::dmat3& covariance_m2,
                                                    double factor) {
  const glm::dvec3 in_camera = pinhole.camera_from_world * in_world;
  if (in_camera.z < kNear) return std::nullopt;
  const glm::dvec2 middle =
      pinhole.lens.focal_px * glm::dvec2(in_camera) / in_camera.z + pinhole.lens.principal_px;
  const glm::dmat2 spread = spread_in_picture(pinhole, in_camera, covariance_m2);
  // Its Cholesky factor takes the unit circle to the ellipse
  const double a = std::sqrt(std::max(0.0, spread[0][0]));
  const double b = a > 0.0 ? spread[0][1] / a : 0.0;
  const double c = std::sqrt(std::max(0.0, spread[1][1] - b * b));
  std::vector<glm::dvec2> outline;
  for (int i = 0; i < kOutlinePoints; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kOutlinePoints;
    const glm::dvec2 on_circle(std::cos(turn), std::sin(turn));
    outline.push_back(middle +
                      factor * glm::dvec2(a * on_circle.x, b * on_circle.x + c * on_circle.y));
  }
  return outline;
}

double exaggeration_for(std::span<const glm::dmat3> covariances_m2, double wanted_m) {
  std::vector<double> sigmas;
  for (const glm::dmat3& covariance : covariances_m2) {
    const double sigma = spread(covariance);
    if (sigma > 0.0) sigmas.push_back(sigma);
  }
  if (sigmas.empty()) return 1.0;
  const auto middle = sigmas.begin() + std::ptrdiff_t(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  const double wanted = std::max(1.0, wanted_m / *middle);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= wanted) return step * power;
  }
  return power;
}

}  // namespace bosk
