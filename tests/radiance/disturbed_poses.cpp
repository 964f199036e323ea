#include "tests/radiance/disturbed_poses.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/geometry/rotation.h"
#include "core/radiance/pose_refinement.h"

namespace bosk {
namespace {

std::vector<glm::dvec3> corners_of(const Box& box) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(box.lower + glm::dvec3(i & 1, i >> 1 & 1, i >> 2) * box.size());
  }
  return corners;
}

}  // namespace

Photos disturbed(Photos photos, double error_px, std::uint64_t seed) {
  for (std::size_t i = 0; i < photos.size(); ++i) {
    Random random(seed, i);
    const double angle = error_px / photos[i].camera.lens.focal_px.x;
    const glm::dvec3 turn = angle * glm::dvec3(random.normal(), random.normal(), random.normal());
    RigidTransform& pose = photos[i].camera.camera_from_world;
    pose = RigidTransform{rotation_from_rodrigues(turn), glm::dvec3(0.0)} * pose;
  }
  return photos;
}

double rms_px(const Photos& truth, const std::vector<RigidTransform>& poses, const Box& crown) {
  std::vector<Camera> wanted, given;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    wanted.push_back(truth[i].camera);
    given.push_back(truth[i].camera);
    given.back().camera_from_world = poses[i];
  }
  const std::vector<glm::dvec3> corners = corners_of(crown);
  const Similarity move = alignment(wanted, given, corners);
  double square = 0.0, count = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    given[i].camera_from_world = moved(given[i].camera_from_world, move);
    for (const glm::dvec3& corner : corners) {
      const auto is = project(wanted[i], corner), seen = project(given[i], corner);
      if (!is || !seen) continue;
      square += glm::dot(*is - *seen, *is - *seen);
      count += 1.0;
    }
  }
  return std::sqrt(square / std::max(count, 1.0));
}

std::vector<RigidTransform> poses_of(const Photos& photos) {
  std::vector<RigidTransform> poses;
  for (const Photo& photo : photos) poses.push_back(photo.camera.camera_from_world);
  return poses;
}

}  // namespace bosk
