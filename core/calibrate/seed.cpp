#include "core/calibrate/seed.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "core/base/number_text.h"

namespace bosk {
namespace {

PartialScene nothing_known(const SeedScene& scene) {
  PartialScene partial;
  partial.camera_from_world.resize(scene.cameras());
  partial.points.resize(scene.points());
  return partial;
}

glm::dvec3 mean_bearing(const SeedScene& scene, std::size_t camera) {
  glm::dvec3 sum(0.0, 0.0, 1e-6);
  for (const std::size_t i : scene.of_camera[camera])
    sum += scene.bearings[i].value_or(glm::dvec3(0.0));
  return glm::normalize(sum);
}

// Upright, at `angle` on the unit circle, so that `bearing` points at the circle's middle.
RigidTransform on_circle(double angle, const glm::dvec3& bearing) {
  const glm::dvec3 place(std::cos(angle), std::sin(angle), 0.0);
  const double pan = std::atan2(bearing.x, bearing.z);
  const double tilt = std::atan2(-bearing.y, std::hypot(bearing.x, bearing.z));
  const double heading = angle + std::numbers::pi + pan;  // of the optical axis seen from above
  const glm::dvec3 level(std::cos(heading), std::sin(heading), 0.0), up(0.0, 0.0, 1.0);
  const glm::dvec3 forward = std::cos(tilt) * level - std::sin(tilt) * up;
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  const glm::dmat3 world_from_camera(right, glm::cross(forward, right), forward);
  const glm::dmat3 turn = glm::transpose(world_from_camera);
  return {turn, -(turn * place)};
}

Seed orbit_seed(const SeedScene& scene, double turns) {
  Seed seed{"orbit of " + number_text(turns, 2) + " turns", nothing_known(scene)};
  for (std::size_t i = 0; i < scene.cameras(); ++i) {
    const double angle = 2.0 * std::numbers::pi * turns * double(i) / double(scene.cameras());
    seed.scene.camera_from_world[i] = on_circle(angle, mean_bearing(scene, i));
  }
  for (std::size_t i = 0; i < scene.points(); ++i)
    seed.scene.points[i] = seed_point(scene, seed.scene, i);
  return seed;
}

// Two cameras and the points that both see.
struct Pair {
  std::size_t first = 0, second = 0;
  std::vector<std::array<std::size_t, 2>> sightings;
  double score = 0.0;
};

Pair pair_of(const SeedScene& scene, std::size_t first, std::size_t second) {
  Pair pair{first, second, {}, 0.0};
  std::map<int, std::size_t> seen;
  for (const std::size_t i : scene.of_camera[first])
    if (scene.bearings[i]) seen[scene.sighting(i).point] = i;
  for (const std::size_t i : scene.of_camera[second]) {
    const auto other = seen.find(scene.sighting(i).point);
    if (other != seen.end() && scene.bearings[i]) pair.sightings.push_back({other->second, i});
  }
  return pair;
}

// How much the points move relative to each other from one photo to the other: turns alone don't
// count, so that two photos from one place score low.
double parallax(const SeedScene& scene, const Pair& pair) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t a = 0; a < pair.sightings.size(); ++a) {
    const std::size_t b = (a + 1) % pair.sightings.size();
    const auto angle = [&](int side) {
      const auto& p = *scene.bearings[pair.sightings[a][std::size_t(side)]];
      const auto& q = *scene.bearings[pair.sightings[b][std::size_t(side)]];
      return std::acos(std::clamp(glm::dot(p, q), -1.0, 1.0));
    };
    sum += std::abs(angle(0) - angle(1));
    ++count;
  }
  return sum / std::max(count, 1);
}

std::vector<Pair> best_pairs(const SeedScene& scene, std::size_t most) {
  constexpr std::size_t kFewest = 6;
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < scene.cameras(); ++a) {
    for (std::size_t b = a + 1; b < scene.cameras(); ++b) {
      Pair pair = pair_of(scene, a, b);
      if (pair.sightings.size() < kFewest) continue;
      pair.score =
          double(pair.sightings.size() - kFewest + 1) * std::min(parallax(scene, pair), 0.05);
      pairs.push_back(std::move(pair));
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& x, const Pair& y) { return x.score > y.score; });
  std::vector<Pair> chosen;
  for (Pair& pair : pairs) {
    const auto shares = [&](const Pair& other) {
      return other.first == pair.first || other.second == pair.second;
    };
    if (chosen.size() < most && std::none_of(chosen.begin(), chosen.end(), shares))
      chosen.push_back(std::move(pair));
  }
  return chosen;
}

// The second camera of the pair seen from the first, at distance 1; none where OpenCV finds none.
std::optional<RigidTransform> second_from_first(const SeedScene& scene, const Pair& pair) {
  std::vector<cv::Point2d> first, second;
  for (const auto& [a, b] : pair.sightings) {
    first.emplace_back(scene.bearings[a]->x / scene.bearings[a]->z,
                       scene.bearings[a]->y / scene.bearings[a]->z);
    second.emplace_back(scene.bearings[b]->x / scene.bearings[b]->z,
                        scene.bearings[b]->y / scene.bearings[b]->z);
  }
  try {
    const cv::Mat one = cv::Mat::eye(3, 3, CV_64F);
    const cv::Mat essential =
        cv::findEssentialMat(first, second, one, cv::RANSAC, 0.999, 4.0 / scene.focal_px);
    if (essential.rows != 3) return std::nullopt;
    cv::Mat turn, shift;
    cv::recoverPose(essential, first, second, one, turn, shift);
    RigidTransform pose;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        pose.rotation[column][row] = turn.at<double>(row, column);
      pose.translation[row] = shift.at<double>(row);
    }
    return pose;
  } catch (const cv::Exception&) {
    return std::nullopt;  // points that define no essential matrix
  }
}

}  // namespace

std::vector<Seed> orbit_seeds(const SeedScene& scene) {
  std::vector<Seed> seeds;
  for (const double turns : {1.0, -1.0, 0.5, -0.5, 0.75, -0.75, 2.0, -2.0})
    seeds.push_back(orbit_seed(scene, turns));
  return seeds;
}

std::vector<Seed> pair_seeds(const SeedScene& scene, std::size_t most, const Progress& progress) {
  std::vector<Seed> seeds;
  for (const Pair& pair : best_pairs(scene, most)) {
    const std::optional<RigidTransform> second = second_from_first(scene, pair);
    if (!second) continue;
    PartialScene partial = nothing_known(scene);
    partial.camera_from_world[pair.first] = RigidTransform{};
    partial.camera_from_world[pair.second] = second;
    seeds.push_back(
        {"photos " + std::to_string(pair.first + 1) + " and " + std::to_string(pair.second + 1),
         grown(scene, std::move(partial), progress)});
  }
  return seeds;
}

std::vector<Seed> body_seeds(const SeedScene& scene, const std::vector<SeedBody>& bodies,
                             const Progress& progress) {
  std::vector<Seed> seeds;
  for (const SeedBody& body : bodies) {
    PartialScene partial = nothing_known(scene);
    for (std::size_t i = 0; i < body.points.size(); ++i)
      partial.points[std::size_t(body.points[i])] = body.in_body[i];
    partial = grown(scene, std::move(partial), progress);
    const auto placed =
        std::count_if(partial.camera_from_world.begin(), partial.camera_from_world.end(),
                      [](const auto& pose) { return pose.has_value(); });
    if (placed >= 2) seeds.push_back({"a body of known shape", std::move(partial)});
  }
  return seeds;
}

}  // namespace bosk
