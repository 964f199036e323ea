#include "core/calibrate/seed_pose.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/base/random.h"
#include "core/calibrate/bundle_loss.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

constexpr std::size_t kMostTriples = 84;  // all of 9 sightings
constexpr std::size_t kMostRefined = 6;

using Triple = std::array<std::size_t, 3>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

std::vector<Triple> triples_of(std::size_t count) {
  std::vector<Triple> triples;
  if (count <= 9) {
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = a + 1; b < count; ++b)
        for (std::size_t c = b + 1; c < count; ++c) triples.push_back({a, b, c});
    return triples;
  }
  Random random(1);
  while (triples.size() < kMostTriples) {
    const Triple triple{random.below(count), random.below(count), random.below(count)};
    if (triple[0] != triple[1] && triple[0] != triple[2] && triple[1] != triple[2])
      triples.push_back(triple);
  }
  return triples;
}

double squared_sigmas(const PoseSighting& sighting, const RigidTransform& pose) {
  const glm::dvec3 in_camera = pose * sighting.in_world;
  const double along = glm::dot(in_camera, sighting.bearing);
  if (!(along > 0.0)) return kBehind;
  const glm::dvec3 off = (in_camera / along - sighting.bearing) / sighting.sigma;
  return std::min(glm::dot(off, off), kBehind);
}

double pose_cost(std::span<const PoseSighting> sightings, const RigidTransform& pose,
                 double loss_scale) {
  double cost = 0.0;
  for (const PoseSighting& sighting : sightings)
    cost += robust_loss(squared_sigmas(sighting, pose), loss_scale).cost;
  return cost;
}

bool is_finite(const RigidTransform& pose) {
  double sum = glm::dot(pose.translation, glm::dvec3(1.0));
  for (int i = 0; i < 3; ++i) sum += glm::dot(pose.rotation[i], glm::dvec3(1.0));
  return std::isfinite(sum);
}

void add_poses_of(std::span<const PoseSighting> sightings, const Triple& triple,
                  std::vector<RigidTransform>& poses) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> seen;
  for (const std::size_t i : triple) {
    const auto& [in_world, bearing, sigma] = sightings[i];
    if (!(bearing.z > 0.05)) return;
    points.emplace_back(in_world.x, in_world.y, in_world.z);
    seen.emplace_back(bearing.x / bearing.z, bearing.y / bearing.z);
  }
  std::vector<cv::Mat> turns, shifts;
  cv::solveP3P(points, seen, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), turns, shifts,
               cv::SOLVEPNP_AP3P);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double* turn = turns[i].ptr<double>();
    const double* shift = shifts[i].ptr<double>();
    const RigidTransform pose{rotation_from_rodrigues({turn[0], turn[1], turn[2]}),
                              {shift[0], shift[1], shift[2]}};
    if (is_finite(pose)) poses.push_back(pose);
  }
}

// Gauss and Newton's step of a pose, damped.
Vector6 pose_step(std::span<const PoseSighting> sightings, const RigidTransform& pose,
                  double loss_scale, double damping) {
  Matrix6 normal = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  for (const PoseSighting& sighting : sightings) {
    const glm::dvec3 p = pose * sighting.in_world, b = sighting.bearing;
    const double along = glm::dot(p, b);
    if (!(along > 0.0)) continue;
    const Eigen::Vector3d point(p.x, p.y, p.z), bearing(b.x, b.y, b.z);
    const Eigen::Vector3d off = (point / along - bearing) / sighting.sigma;
    const Eigen::Matrix3d by_point =
        (Eigen::Matrix3d::Identity() - point * bearing.transpose() / along) /
        (along * sighting.sigma);
    Eigen::Matrix<double, 3, 6> by;
    by << -by_point * cross_matrix(point), by_point;
    const double weight = robust_loss(off.squaredNorm(), loss_scale).weight;
    normal += weight * by.transpose() * by;
    gradient += weight * by.transpose() * off;
  }
  normal.diagonal() *= 1.0 + damping;
  normal.diagonal().array() += 1e-9;
  return -(normal.ldlt().solve(gradient));
}

RigidTransform moved(const RigidTransform& pose, const Vector6& step) {
  const glm::dmat3 turn = rotation_from_rodrigues({step[0], step[1], step[2]});
  return {nearest_rotation(turn * pose.rotation),
          turn * pose.translation + glm::dvec3(step[3], step[4], step[5])};
}

bool same_view(const RigidTransform& a, const RigidTransform& b) {
  const glm::dmat3 turn = a.rotation * glm::transpose(b.rotation);
  const glm::dvec3 apart = inverse(a).translation - inverse(b).translation;
  return glm::length(rodrigues_from_rotation(nearest_rotation(turn))) < 0.02 &&
         glm::length(apart) < 0.02 * glm::length(a.translation);
}

}  // namespace

PlacedPose refined_pose(std::span<const PoseSighting> sightings, const RigidTransform& start,
                        double loss_scale) {
  PlacedPose best{start, pose_cost(sightings, start, loss_scale)};
  double damping = 1e-3;
  for (int i = 0; i < 30 && damping < 1e6; ++i) {
    const Vector6 step = pose_step(sightings, best.camera_from_world, loss_scale, damping);
    damping *= 10.0;
    if (!step.allFinite()) continue;
    const RigidTransform next = moved(best.camera_from_world, step);
    const double cost = pose_cost(sightings, next, loss_scale);
    if (!(cost < best.cost)) continue;
    const bool settled = best.cost - cost < 1e-6 * best.cost;
    best = {next, cost};
    damping /= 100.0;
    if (settled) break;
  }
  return best;
}

std::vector<PlacedPose> place_camera(std::span<const PoseSighting> sightings, double loss_scale) {
  if (sightings.size() < 4) return {};
  std::vector<RigidTransform> suggested;
  for (const Triple& triple : triples_of(sightings.size()))
    add_poses_of(sightings, triple, suggested);
  std::vector<PlacedPose> ranked;
  for (const RigidTransform& pose : suggested)
    ranked.push_back({pose, pose_cost(sightings, pose, loss_scale)});
  const auto cheaper = [](const PlacedPose& a, const PlacedPose& b) { return a.cost < b.cost; };
  std::stable_sort(ranked.begin(), ranked.end(), cheaper);
  std::vector<PlacedPose> refined;
  std::vector<RigidTransform> starts;
  for (const PlacedPose& pose : ranked) {
    const auto is_same = [&](const RigidTransform& start) {
      return same_view(start, pose.camera_from_world);
    };
    if (std::any_of(starts.begin(), starts.end(), is_same)) continue;
    starts.push_back(pose.camera_from_world);
    const PlacedPose better = refined_pose(sightings, pose.camera_from_world, loss_scale);
    const auto is_known = [&](const PlacedPose& known) {
      return same_view(known.camera_from_world, better.camera_from_world);
    };
    if (std::none_of(refined.begin(), refined.end(), is_known)) refined.push_back(better);
    if (starts.size() == kMostRefined) break;
  }
  std::stable_sort(refined.begin(), refined.end(), cheaper);
  return refined;
}

}  // namespace bosk
