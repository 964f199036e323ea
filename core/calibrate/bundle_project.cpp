#include "core/calibrate/bundle_project.h"

namespace bosk {
namespace {

mrcal_point3_t as_mrcal(const glm::dvec3& point) {
  mrcal_point3_t result{};
  for (int axis = 0; axis < 3; ++axis) result.xyz[axis] = point[axis];
  return result;
}

}  // namespace

ProjectedSightings project_sightings(const BundleProblem& problem, const BundleState& state,
                                     std::span<const BundleSighting> of_one_camera,
                                     bool derivatives) {
  const std::size_t count = of_one_camera.size();
  ProjectedSightings result;
  std::vector<mrcal_point3_t> points;
  for (const BundleSighting& sighting : of_one_camera) {
    const auto camera = std::size_t(sighting.camera), point = std::size_t(sighting.point);
    const glm::dvec3 in_camera = state.camera_from_world[camera] * state.points[point];
    result.in_camera.push_back(in_camera);
    result.in_front.push_back(in_camera.z > kLeastDepth);
    points.push_back(as_mrcal(result.in_front.back() ? in_camera : glm::dvec3(0.0, 0.0, 1.0)));
  }
  result.pixel.resize(count);
  if (derivatives) {
    result.by_point.resize(count);
    result.by_lens.resize(count * 2 * state.intrinsics.size());
  }
  const mrcal_lensmodel_t model = mrcal_model(problem.family);
  mrcal_project(result.pixel.data(), derivatives ? result.by_point.data()->data() : nullptr,
                derivatives ? result.by_lens.data() : nullptr, points.data(), int(count), &model,
                state.intrinsics.data());
  return result;
}

std::vector<std::span<const BundleSighting>> by_camera(const BundleProblem& problem) {
  std::vector<std::span<const BundleSighting>> groups;
  const std::span<const BundleSighting> all(problem.sightings);
  for (std::size_t first = 0; first < all.size();) {
    std::size_t end = first;
    while (end < all.size() && all[end].camera == all[first].camera) ++end;
    groups.push_back(all.subspan(first, end - first));
    first = end;
  }
  return groups;
}

}  // namespace bosk
