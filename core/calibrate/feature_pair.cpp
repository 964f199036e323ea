#include "core/calibrate/feature_pair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>

namespace bosk {
namespace {

constexpr std::size_t kFewestCommon = 30;  // points of a pair to begin with
constexpr std::size_t kMostTried = 24;     // pairs whose essential matrix is computed
constexpr double kGoodAngle = 0.14;        // radians; more parallax is no better

struct CommonPoints {
  int first = 0, second = 0;
  std::vector<cv::Point2d> in_first, in_second;  // on the plane z = 1
};

cv::Point2d on_plane(const glm::dvec3& bearing) {
  return {bearing.x / bearing.z, bearing.y / bearing.z};
}

bool is_ahead(const std::optional<glm::dvec3>& bearing) { return bearing && bearing->z > 0.1; }

void collect(const SeedScene& scene, std::size_t point,
             std::map<std::pair<int, int>, CommonPoints>& pairs) {
  const auto& sightings = scene.of_point[point];
  for (std::size_t a = 0; a < sightings.size(); ++a)
    for (std::size_t b = a + 1; b < sightings.size(); ++b) {
      const auto &p = scene.bearings[sightings[a]], &q = scene.bearings[sightings[b]];
      if (!is_ahead(p) || !is_ahead(q)) continue;
      const int first = scene.sighting(sightings[a]).camera;
      const int second = scene.sighting(sightings[b]).camera;
      CommonPoints& common = pairs[{first, second}];
      common.first = first;
      common.second = second;
      common.in_first.push_back(on_plane(*p));
      common.in_second.push_back(on_plane(*q));
    }
}

std::vector<CommonPoints> most_common(const SeedScene& scene) {
  std::map<std::pair<int, int>, CommonPoints> pairs;
  for (std::size_t point = 0; point < scene.points(); ++point) collect(scene, point, pairs);
  std::vector<CommonPoints> result;
  for (auto& [cameras, common] : pairs)
    if (common.in_first.size() >= kFewestCommon) result.push_back(std::move(common));
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.in_first.size() > b.in_first.size();
  });
  return result;
}

RigidTransform transform_of(const cv::Mat& rotation, const cv::Mat& translation) {
  RigidTransform transform;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      transform.rotation[column][row] = rotation.at<double>(row, column);
    transform.translation[row] = translation.at<double>(row);
  }
  return transform;
}

// Sum over the points that agree of their angle between the two rays, up to a good one.
double worth_of(const CommonPoints& common, const RigidTransform& second_from_first,
                const cv::Mat& agrees) {
  double worth = 0.0;
  for (std::size_t i = 0; i < common.in_first.size(); ++i) {
    if (!agrees.at<std::uint8_t>(int(i))) continue;
    const auto &p = common.in_first[i], &q = common.in_second[i];
    const glm::dvec3 a = glm::normalize(second_from_first.rotation * glm::dvec3(p.x, p.y, 1.0));
    const glm::dvec3 b = glm::normalize(glm::dvec3(q.x, q.y, 1.0));
    worth += std::min(glm::length(glm::cross(a, b)), kGoodAngle) / kGoodAngle;
  }
  return worth;
}

std::optional<FeaturePair> pair_of(const CommonPoints& common, double focal_px) {
  cv::Mat agrees, rotation, translation;
  const cv::Mat identity = cv::Mat::eye(3, 3, CV_64F);
  const cv::Mat essential = cv::findEssentialMat(common.in_first, common.in_second, identity,
                                                 cv::RANSAC, 0.999, 2.0 / focal_px, 1000, agrees);
  if (essential.rows != 3 || essential.cols != 3) return {};
  const int ahead = cv::recoverPose(essential, common.in_first, common.in_second, identity,
                                    rotation, translation, agrees);
  if (ahead < int(kFewestCommon) / 2) return {};
  FeaturePair pair{common.first, common.second, transform_of(rotation, translation), 0.0};
  pair.worth = worth_of(common, pair.second_from_first, agrees);
  return pair;
}

}  // namespace

std::vector<FeaturePair> starting_pairs(const SeedScene& scene, const Progress& progress) {
  std::vector<CommonPoints> common = most_common(scene);
  if (common.size() > kMostTried) common.resize(kMostTried);
  std::vector<FeaturePair> pairs;
  for (const CommonPoints& points : common) {
    progress.check();
    if (const auto pair = pair_of(points, scene.focal_px)) pairs.push_back(*pair);
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.worth > b.worth; });
  return pairs;
}

std::optional<RigidTransform> pose_by_points(const SeedScene& scene, const PartialScene& partial,
                                             int camera, double error_px, std::size_t fewest) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> seen;
  for (const PoseSighting& sighting : pose_sightings(scene, partial, std::size_t(camera))) {
    if (sighting.bearing.z <= 0.1) continue;
    points.emplace_back(sighting.in_world.x, sighting.in_world.y, sighting.in_world.z);
    seen.push_back(on_plane(sighting.bearing));
  }
  if (points.size() < fewest) return {};
  cv::Mat rodrigues, translation, rotation;
  std::vector<int> agree;
  const cv::Mat identity = cv::Mat::eye(3, 3, CV_64F);
  const bool found =
      cv::solvePnPRansac(points, seen, identity, cv::noArray(), rodrigues, translation, false, 2000,
                         float(error_px / scene.focal_px), 0.9999, agree, cv::SOLVEPNP_AP3P);
  if (!found || agree.size() < std::max(fewest, points.size() / 4)) return {};
  cv::Rodrigues(rodrigues, rotation);
  return transform_of(rotation, translation);
}

}  // namespace bosk
