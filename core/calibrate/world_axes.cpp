#include "core/calibrate/world_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/calibrate/world.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

using glm::dvec3;

glm::dvec3 mean_of(std::span<const dvec3> points) {
  dvec3 sum(0.0);
  for (const dvec3& point : points) sum += point;
  return sum / double(std::max<std::size_t>(points.size(), 1));
}

// Unit length, or none for a sum that cancels out.
void add_direction(const dvec3& sum, std::vector<dvec3>& directions) {
  const double length = glm::length(sum);
  if (length > 1e-9) directions.push_back(sum / length);
}

dvec3 photo_tops(std::span<const RigidTransform> camera_from_world) {
  dvec3 sum(0.0);
  for (const RigidTransform& camera : camera_from_world)
    sum += inverse(camera).rotation * dvec3(0.0, -1.0, 0.0);
  return sum;
}

std::vector<dvec3> centres_of(std::span<const RigidTransform> camera_from_world) {
  std::vector<dvec3> centres;
  for (const RigidTransform& camera : camera_from_world)
    centres.push_back(inverse(camera).translation);
  return centres;
}

}  // namespace

double mean_distance(const BundleState& state, const dvec3& point) {
  double sum = 0.0;
  for (const dvec3& centre : centres_of(state.camera_from_world))
    sum += glm::distance(centre, point);
  return std::max(sum / double(state.camera_from_world.size()), 1e-12);
}

double lowest_point(const BundleState& state) {
  double lowest = state.points.front().z;
  for (const dvec3& point : state.points) lowest = std::min(lowest, point.z);
  return lowest;
}

glm::dmat3 rotation_to_z(const dvec3& up) {
  const dvec3 axis = glm::cross(up, dvec3(0.0, 0.0, 1.0));
  const double sine = glm::length(axis), angle = std::atan2(sine, up.z);
  if (sine > 1e-12) return rotation_from_rodrigues(axis / sine * angle);
  return rotation_from_rodrigues({angle, 0.0, 0.0});
}

std::vector<dvec3> possible_ups(const BundleProblem& survey, const BundleState& state) {
  dvec3 sticks(0.0), gravity(0.0);
  for (const PlumbRow& row : survey.plumbs)
    sticks += state.points[std::size_t(row.top)] - state.points[std::size_t(row.foot)];
  for (const UpRow& row : survey.ups)
    gravity +=
        inverse(state.camera_from_world[std::size_t(row.camera)]).rotation * row.up_in_camera;
  std::vector<dvec3> ups;
  add_direction(sticks, ups);
  add_direction(gravity, ups);
  ups.push_back(up_of_cameras(state.camera_from_world));
  add_direction(photo_tops(state.camera_from_world), ups);
  return ups;
}

double height_scale(std::span<const CoordinateRow> coordinates, std::span<const dvec3> points) {
  double own_mean = 0.0, known_mean = 0.0, count = 0.0;
  for (const CoordinateRow& row : coordinates) {
    if (row.axis != 2) continue;
    own_mean += points[std::size_t(row.point)].z;
    known_mean += row.value;
    count += 1.0;
  }
  if (count < 2.0) return 1.0;
  double both = 0.0, own = 0.0;
  for (const CoordinateRow& row : coordinates) {
    if (row.axis != 2) continue;
    const double z = points[std::size_t(row.point)].z - own_mean / count;
    both += z * (row.value - known_mean / count);
    own += z * z;
  }
  return both > 0.0 && own > 0.0 ? both / own : 1.0;
}

dvec3 mean_coordinate_miss(std::span<const CoordinateRow> coordinates, const BundleState& state) {
  dvec3 sum(0.0), count(0.0);
  for (const CoordinateRow& row : coordinates) {
    sum[row.axis] += row.value - state.points[std::size_t(row.point)][row.axis];
    count[row.axis] += 1.0;
  }
  return sum / glm::max(count, dvec3(1.0));
}

std::map<int, dvec3> surveyed_places(std::span<const CoordinateRow> coordinates) {
  std::map<int, int> measured;
  std::map<int, dvec3> places;
  for (const CoordinateRow& row : coordinates) {
    measured[row.point] |= 1 << row.axis;
    places[row.point][row.axis] = row.value;
  }
  std::erase_if(places, [&](const auto& place) { return measured[place.first] != 7; });
  return places;
}

RigidTransform fit_body(std::span<const dvec3> in_body, std::span<const dvec3> in_world) {
  const dvec3 body_mean = mean_of(in_body), world_mean = mean_of(in_world);
  glm::dmat3 world_by_body(0.0);
  for (std::size_t i = 0; i < in_body.size(); ++i)
    world_by_body += glm::outerProduct(in_world[i] - world_mean, in_body[i] - body_mean);
  const glm::dmat3 turn = fit_rotation(world_by_body).rotation;
  return {turn, world_mean - turn * body_mean};
}

// The point p of least sum |(1 - d d^T) (p - c)|^2 over axes d through centres c.
dvec3 crown_point(const BundleState& state) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const RigidTransform& camera : state.camera_from_world) {
    const RigidTransform world_from_camera = inverse(camera);
    const dvec3 d = world_from_camera.rotation[2], c = world_from_camera.translation;
    const Eigen::Vector3d direction(d.x, d.y, d.z), centre(c.x, c.y, c.z);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
    normal += across;
    right += across * centre;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normal);
  if (solver.eigenvalues()[0] < 1e-2 * solver.eigenvalues()[2]) return mean_of(state.points);
  const Eigen::Vector3d point =
      solver.eigenvectors() *
      (solver.eigenvectors().transpose() * right).cwiseQuotient(solver.eigenvalues());
  return {point.x(), point.y(), point.z()};
}

dvec3 up_of_cameras(std::span<const RigidTransform> camera_from_world) {
  const std::vector<dvec3> centres = centres_of(camera_from_world);
  const dvec3 mean = mean_of(centres), tops = photo_tops(camera_from_world);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const dvec3& centre : centres) {
    const dvec3 off = centre - mean;
    const Eigen::Vector3d arm(off.x, off.y, off.z);
    spread += arm * arm.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const dvec3 up(normal.x(), normal.y(), normal.z());
  const bool flat = solver.eigenvalues()[1] > 1e-2 * solver.eigenvalues()[2];
  if (!flat && glm::length(tops) > 1e-9) return glm::normalize(tops);
  return glm::dot(up, tops) < 0.0 ? -up : up;
}

}  // namespace bosk
