#include "ui/workstation/calibrate/frusta.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bosk {
namespace {

constexpr double kWheelStep = 0.85;
constexpr double kNear = 1e-3;  // metres; nothing nearer to an eye is drawn

glm::dvec3 outwards(const OrbitView& view) {
  return {std::cos(view.elevation) * std::cos(view.heading),
          std::cos(view.elevation) * std::sin(view.heading), std::sin(view.elevation)};
}

glm::dvec3 right_of(const OrbitView& view) {
  return {-std::sin(view.heading), std::cos(view.heading), 0.0};
}

glm::dvec2 seen_place(const Camera& pinhole, const glm::dvec3& in_camera) {
  return pinhole.lens.focal_px * glm::dvec2(in_camera) / in_camera.z + pinhole.lens.principal_px;
}

// Of a pixel at depth 1; a lens without an answer there is taken as a pinhole.
glm::dvec3 ray_of(const Lens& lens, const glm::dvec2& pixel) {
  const auto direction = camera_from_pixel(lens, pixel);
  if (direction && direction->z > 0.05) return *direction / direction->z;
  return {(pixel - lens.principal_px) / lens.focal_px, 1.0};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_distance(std::span<const Camera> cameras, const glm::dvec3& middle) {
  std::vector<double> distances;
  for (const Camera& camera : cameras) {
    distances.push_back(glm::distance(camera.centre_in_world(), middle));
  }
  const double distance = median(std::move(distances));
  return distance > 0.0 ? distance : 1.0;
}

}  // namespace

glm::dvec3 eye_of(const OrbitView& view) { return view.target + view.distance * outwards(view); }

OrbitView turned(const OrbitView& view, const glm::dvec2& delta_px, double height_px) {
  const glm::dvec2 angle = delta_px / std::max(1.0, height_px) * std::numbers::pi;
  OrbitView result = view;
  result.heading = std::remainder(view.heading - angle.x, 2.0 * std::numbers::pi);
  result.elevation = std::clamp(view.elevation + angle.y, -kSteepestOrbit, kSteepestOrbit);
  return result;
}

OrbitView moved(const OrbitView& view, const glm::dvec2& delta_px, double height_px) {
  const double metres_a_px =
      2.0 * view.distance * std::tan(0.5 * kOrbitViewAngle) / std::max(1.0, height_px);
  const glm::dvec3 right = right_of(view), up = glm::cross(outwards(view), right);
  OrbitView result = view;
  result.target += metres_a_px * (delta_px.y * up - delta_px.x * right);
  return result;
}

OrbitView nearer(const OrbitView& view, double steps) {
  OrbitView result = view;
  result.distance = std::clamp(view.distance * std::pow(kWheelStep, steps), 1e-3, 1e6);
  return result;
}

OrbitView overview_of(std::span<const Camera> cameras, const glm::dvec3& middle) {
  double farthest = 0.0;
  for (const Camera& camera : cameras) {
    farthest = std::max(farthest, glm::distance(camera.centre_in_world(), middle));
  }
  OrbitView view;
  view.target = middle;
  // A fifth more than the ball of all eyes needs
  view.distance = 1.2 * (farthest > 0.0 ? farthest : 1.0) / std::sin(0.5 * kOrbitViewAngle);
  return view;
}

Camera camera_of(const OrbitView& view, const glm::dvec2& size_px) {
  Camera camera;
  camera.name = "view";
  camera.lens.width_px = int(size_px.x);
  camera.lens.height_px = int(size_px.y);
  camera.lens.focal_px = glm::dvec2(0.5 * size_px.y / std::tan(0.5 * kOrbitViewAngle));
  camera.lens.principal_px = 0.5 * size_px - 0.5;
  const glm::dvec3 ahead = -outwards(view), right = right_of(view);
  camera.camera_from_world.rotation =
      glm::transpose(glm::dmat3(right, glm::cross(ahead, right), ahead));
  camera.camera_from_world.translation = -(camera.camera_from_world.rotation * eye_of(view));
  return camera;
}

Camera camera_through(const Camera& camera, const glm::dvec2& size_px) {
  Camera through = camera;
  const glm::dvec2 picture(camera.lens.width_px, camera.lens.height_px);
  const double scale = std::min(size_px.x / picture.x, size_px.y / picture.y);
  through.lens = undistorted(camera.lens);
  through.lens.width_px = int(size_px.x);
  through.lens.height_px = int(size_px.y);
  through.lens.focal_px *= scale;
  through.lens.principal_px =
      (camera.lens.principal_px + 0.5) * scale - 0.5 + 0.5 * (size_px - scale * picture);
  return through;
}

glm::dvec3 Frustum::at(double across, double down) const {
  return glm::mix(glm::mix(corners[0], corners[1], across),
                  glm::mix(corners[3], corners[2], across), down);
}

Frustum frustum_of(const Camera& camera, double depth) {
  const double right = camera.lens.width_px - 0.5, bottom = camera.lens.height_px - 0.5;
  const glm::dvec2 pixels[] = {{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}};
  const RigidTransform world_from_camera = inverse(camera.camera_from_world);
  Frustum frustum;
  frustum.name = camera.name;
  frustum.eye = world_from_camera.translation;
  for (std::size_t i = 0; i < 4; ++i) {
    frustum.corners[i] = world_from_camera * (depth * ray_of(camera.lens, pixels[i]));
  }
  return frustum;
}

double frustum_depth(std::span<const Camera> cameras, const glm::dvec3& middle) {
  return 0.2 * median_distance(cameras, middle);
}

std::vector<std::size_t> back_to_front(std::span<const Frustum> frusta, const glm::dvec3& eye) {
  std::vector<std::size_t> order(frusta.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return glm::distance(frusta[a].middle(), eye) > glm::distance(frusta[b].middle(), eye);
  });
  return order;
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> seen_line(const Camera& pinhole,
                                                           const glm::dvec3& from,
                                                           const glm::dvec3& to) {
  glm::dvec3 a = pinhole.camera_from_world * from, b = pinhole.camera_from_world * to;
  if (a.z < kNear && b.z < kNear) return std::nullopt;
  if (a.z < kNear) a = glm::mix(a, b, (kNear - a.z) / (b.z - a.z));
  if (b.z < kNear) b = glm::mix(b, a, (kNear - b.z) / (a.z - b.z));
  return std::pair(seen_place(pinhole, a), seen_place(pinhole, b));
}

std::optional<std::array<glm::dvec2, 4>> seen_quad(const Camera& pinhole,
                                                   const std::array<glm::dvec3, 4>& corners) {
  std::array<glm::dvec2, 4> seen;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 in_camera = pinhole.camera_from_world * corners[i];
    if (in_camera.z < kNear) return std::nullopt;
    seen[i] = seen_place(pinhole, in_camera);
  }
  return seen;
}

bool is_inside(const std::array<glm::dvec2, 4>& quad, const glm::dvec2& place) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 edge = quad[(i + 1) % 4] - quad[i], to_place = place - quad[i];
    const double turn = edge.x * to_place.y - edge.y * to_place.x;
    left += turn > 0.0;
    right += turn < 0.0;
  }
  return left == 0 || right == 0;
}

double grid_step(double view_width) {
  const double wanted = std::max(1e-9, 0.1 * view_width);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= wanted) return step * power;
  }
  return 10.0 * power;
}

}  // namespace bosk
