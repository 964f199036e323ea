#include "core/calibrate/seed_scene.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

constexpr double kSeedLoss = 30.0;       // sigmas; seeds are far off
constexpr double kLeastSpread = 0.0174;  // radians between rays that fix a point

struct SightLine {
  glm::dvec3 origin{0.0}, direction{0.0};
};

std::vector<SightLine> lines_of(const SeedScene& scene, const PartialScene& partial,
                                std::size_t point) {
  std::vector<SightLine> lines;
  for (const std::size_t i : scene.of_point[point]) {
    const auto& pose = partial.camera_from_world[std::size_t(scene.sighting(i).camera)];
    if (!pose || !scene.bearings[i] || !scene.sighting(i).used) continue;
    const RigidTransform world_from_camera = inverse(*pose);
    lines.push_back(
        {world_from_camera.translation, world_from_camera.rotation * *scene.bearings[i]});
  }
  return lines;
}

bool spread(const std::vector<SightLine>& lines) {
  for (const SightLine& line : lines)
    if (glm::length(glm::cross(line.direction, lines.front().direction)) > kLeastSpread)
      return true;
  return false;
}

double miss(const SightLine& line, const glm::dvec3& point) {
  return glm::length(glm::cross(line.direction, point - line.origin));
}

glm::dvec3 nearest_to(const std::vector<SightLine>& lines, const std::vector<double>& weights) {
  Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const glm::dvec3 &d = lines[i].direction, &o = lines[i].origin;
    const Eigen::Vector3d direction(d.x, d.y, d.z), origin(o.x, o.y, o.z);
    const Eigen::Matrix3d across =
        weights[i] * (Eigen::Matrix3d::Identity() - direction * direction.transpose());
    normal += across;
    right += across * origin;
  }
  const Eigen::Vector3d point = normal.ldlt().solve(right);
  return {point.x(), point.y(), point.z()};
}

double median_of(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void add_points(const SeedScene& scene, PartialScene& partial) {
  for (std::size_t point = 0; point < scene.points(); ++point)
    if (!partial.points[point]) partial.points[point] = seed_point(scene, partial, point);
}

// Bundle adjustment of what is placed so far.
void adjust(const SeedScene& scene, PartialScene& partial, int iterations,
            const Progress& progress) {
  BundleProblem problem;
  problem.family = scene.problem->family;
  problem.lens_free.assign(scene.intrinsics.size(), false);
  problem.sightings = scene.problem->sightings;
  for (std::size_t i = 0; i < problem.sightings.size(); ++i) {
    BundleSighting& sighting = problem.sightings[i];
    sighting.used = sighting.used && scene.bearings[i] &&
                    partial.camera_from_world[std::size_t(sighting.camera)] &&
                    partial.points[std::size_t(sighting.point)];
  }
  BundleState state = completed(scene, partial);
  solve_bundle(problem, state, {kSeedLoss, iterations}, progress);
  for (std::size_t i = 0; i < scene.cameras(); ++i)
    if (partial.camera_from_world[i]) partial.camera_from_world[i] = state.camera_from_world[i];
  for (std::size_t i = 0; i < scene.points(); ++i)
    if (partial.points[i]) partial.points[i] = state.points[i];
}

// The unplaced camera that sees most known points, at least four.
std::optional<std::size_t> next_camera(const SeedScene& scene, const PartialScene& partial,
                                       const std::vector<bool>& tried) {
  std::optional<std::size_t> best;
  std::size_t most = 3;
  for (std::size_t camera = 0; camera < scene.cameras(); ++camera) {
    if (partial.camera_from_world[camera] || tried[camera]) continue;
    const std::size_t known = pose_sightings(scene, partial, camera).size();
    if (known <= most) continue;
    most = known;
    best = camera;
  }
  return best;
}

}  // namespace

SeedScene seed_scene(const BundleProblem& problem, const std::vector<double>& intrinsics,
                     const Lens& lens, std::size_t cameras, std::size_t points) {
  SeedScene scene{&problem, intrinsics, {}, {}, {}, 0.5 * (lens.focal_px.x + lens.focal_px.y)};
  scene.of_camera.resize(cameras);
  scene.of_point.resize(points);
  for (std::size_t i = 0; i < problem.sightings.size(); ++i) {
    const BundleSighting& sighting = problem.sightings[i];
    scene.bearings.push_back(camera_from_pixel(lens, sighting.pixel));
    scene.of_camera[std::size_t(sighting.camera)].push_back(i);
    scene.of_point[std::size_t(sighting.point)].push_back(i);
  }
  return scene;
}

std::optional<glm::dvec3> seed_point(const SeedScene& scene, const PartialScene& partial,
                                     std::size_t point) {
  const std::vector<SightLine> lines = lines_of(scene, partial, point);
  if (lines.size() < 2 || !spread(lines)) return std::nullopt;
  std::vector<double> weights(lines.size(), 1.0);
  glm::dvec3 place = nearest_to(lines, weights);
  for (int round = 0; round < 3 && lines.size() > 2; ++round) {
    std::vector<double> misses;
    for (const SightLine& line : lines) misses.push_back(miss(line, place));
    const double usual = std::max(median_of(misses), 1e-9);
    for (std::size_t i = 0; i < lines.size(); ++i)
      weights[i] = std::pow(1.0 + std::pow(misses[i] / (2.0 * usual), 2.0), -2.0);
    place = nearest_to(lines, weights);
  }
  return place;
}

std::vector<PoseSighting> pose_sightings(const SeedScene& scene, const PartialScene& partial,
                                         std::size_t camera) {
  std::vector<PoseSighting> result;
  for (const std::size_t i : scene.of_camera[camera]) {
    const BundleSighting& sighting = scene.sighting(i);
    const auto& point = partial.points[std::size_t(sighting.point)];
    if (point && scene.bearings[i] && sighting.used)
      result.push_back({*point, *scene.bearings[i], sighting.sigma_px / scene.focal_px});
  }
  return result;
}

PartialScene grown(const SeedScene& scene, PartialScene partial, const Progress& progress) {
  std::vector<bool> tried(scene.cameras(), false);
  add_points(scene, partial);
  int placed = 0;
  while (const auto camera = next_camera(scene, partial, tried)) {
    progress.check();
    tried[*camera] = true;
    const auto poses = place_camera(pose_sightings(scene, partial, *camera), kSeedLoss);
    if (poses.empty()) continue;
    partial.camera_from_world[*camera] = poses.front().camera_from_world;
    add_points(scene, partial);
    if (++placed % 4 == 0) adjust(scene, partial, 4, progress);
  }
  adjust(scene, partial, 4, progress);
  return partial;
}

BundleState completed(const SeedScene& scene, const PartialScene& partial) {
  BundleState state;
  state.intrinsics = scene.intrinsics;
  RigidTransform last{glm::dmat3(1.0), glm::dvec3(0.0, 0.0, 1.0)};
  const auto& poses = partial.camera_from_world;
  const auto first = std::find_if(poses.begin(), poses.end(), [](const auto& p) { return !!p; });
  if (first != poses.end()) last = **first;
  for (const auto& pose : poses) state.camera_from_world.push_back(last = pose.value_or(last));
  for (std::size_t i = 0; i < scene.points(); ++i) {
    const std::size_t seen = scene.of_point[i].front();
    const auto camera = std::size_t(scene.sighting(seen).camera);
    const glm::dvec3 before = glm::length(state.camera_from_world[camera].translation) *
                              scene.bearings[seen].value_or(glm::dvec3(0.0, 0.0, 1.0));
    state.points.push_back(
        partial.points[i].value_or(inverse(state.camera_from_world[camera]) * before));
  }
  return state;
}

}  // namespace bosk
