#include "core/calibrate/solve_start.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/calibrate/uncertainty.h"
#include "core/calibrate/world.h"

namespace bosk {
namespace {

constexpr std::size_t kMostSeedPoints = 160;
constexpr double kAsGood = 12.0;  // cost by which a second solve may be dearer and still as good
constexpr double kElsewhere_px = 2.0;  // at the crown, by which two solves differ

// The points that seeds are tried on, as indices into the input's, ascending: those that were
// measured, then those in most photos.
std::vector<int> seed_points(const SolveInput& input) {
  std::vector<int> seen(input.points.size(), 0), order;
  for (const BundleSighting& sighting : input.problem.sightings)
    ++seen[std::size_t(sighting.point)];
  constexpr int kMeasured = 100'000;
  for (const BodyRow& row : input.problem.bodies) seen[std::size_t(row.point)] += kMeasured;
  for (int i = 0; i < int(seen.size()); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return seen[std::size_t(a)] > seen[std::size_t(b)]; });
  if (order.size() > kMostSeedPoints) order.resize(kMostSeedPoints);
  std::sort(order.begin(), order.end());
  return order;
}

// The input with these points only, and nothing measured but bodies' points.
SolveInput only(const SolveInput& input, const std::vector<int>& points) {
  std::map<int, int> renumbered;
  SolveInput result = input;
  result.points.clear();
  for (const int point : points) {
    renumbered[point] = int(result.points.size());
    result.points.push_back(input.points[std::size_t(point)]);
  }
  result.problem = {};
  result.problem.family = input.problem.family;
  result.problem.lens = input.problem.lens;
  result.problem.lens_free = input.problem.lens_free;
  for (BundleSighting sighting : input.problem.sightings) {
    const auto number = renumbered.find(sighting.point);
    if (number == renumbered.end()) continue;
    sighting.point = number->second;
    result.problem.sightings.push_back(sighting);
  }
  for (BodyRow row : input.problem.bodies) {
    const auto number = renumbered.find(row.point);
    if (number == renumbered.end()) continue;
    row.point = number->second;
    result.problem.bodies.push_back(row);
  }
  return result;
}

std::vector<Seed> first_pose_seeds(const SolveInput& input, const SeedScene& scene,
                                   std::span<const FirstPose> first_poses,
                                   std::span<const PhotoSightings> photos,
                                   const Progress& progress) {
  std::map<std::string, RigidTransform> poses;
  for (const FirstPose& pose : first_poses) poses[pose.photo] = pose.camera_from_scene;
  PartialScene partial;
  partial.points.resize(scene.points());
  std::size_t given = 0;
  for (const std::size_t photo : input.photo_of_camera) {
    const auto pose = poses.find(photos[photo].photo);
    partial.camera_from_world.emplace_back();
    if (pose == poses.end()) continue;
    partial.camera_from_world.back() = pose->second;
    ++given;
  }
  if (given < 2) return {};
  return {{"the first poses", grown(scene, std::move(partial), progress)}};
}

std::vector<Seed> all_seeds(const SolveInput& input, const SeedScene& scene,
                            std::span<const FirstPose> first_poses,
                            std::span<const PhotoSightings> photos, const Progress& progress) {
  std::vector<Seed> seeds = first_pose_seeds(input, scene, first_poses, photos, progress);
  const auto add = [&seeds](std::vector<Seed> more) {
    for (Seed& seed : more) seeds.push_back(std::move(seed));
  };
  add(body_seeds(scene, seed_bodies(input), progress));
  add(orbit_seeds(scene));
  add(pair_seeds(scene, 4, progress));
  return seeds;
}

std::vector<glm::dvec3> places_of(const BundleState& state) {
  std::vector<glm::dvec3> all = state.points;
  for (const RigidTransform& camera : state.camera_from_world)
    all.push_back(inverse(camera).translation);
  return all;
}

// The nearer three quarters of the pairs, as the similarity puts them.
void keep_near(const Similarity& fit, std::vector<glm::dvec3>& source,
               std::vector<glm::dvec3>& target) {
  std::vector<double> misses;
  for (std::size_t i = 0; i < source.size(); ++i)
    misses.push_back(glm::distance(fit * source[i], target[i]));
  std::vector<double> sorted = misses;
  std::sort(sorted.begin(), sorted.end());
  const double bound = sorted[sorted.size() * 3 / 4];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < misses.size(); ++i) {
    if (misses[i] > bound) continue;
    source[kept] = source[i];
    target[kept++] = target[i];
  }
  source.resize(kept);
  target.resize(kept);
}

// The other solve, moved and sized so that most points and cameras lie as near as they can to the
// best.
std::optional<BundleState> beside(const BundleState& best, const BundleState& other) {
  std::vector<glm::dvec3> source = places_of(other), target = places_of(best);
  try {
    Similarity fit = fit_similarity(source, target);
    for (int round = 0; round < 2; ++round) {
      keep_near(fit, source, target);
      fit = fit_similarity(source, target);
    }
    return moved(other, fit);
  } catch (const Error&) {
    return std::nullopt;
  }
}

double crown_shift_px(const BundleProblem& problem, const BundleState& best,
                      const BundleState& other, int camera, const CrownView& crown) {
  BundleProblem view;
  view.family = problem.family;
  BundleState a = best, b = other;
  a.points = b.points = crown_ring(best, camera, crown);
  for (int i = 0; i < int(a.points.size()); ++i)
    view.sightings.push_back({camera, i, glm::dvec2(0.0), 1.0, true});
  const auto in_best = sighting_errors(view, a), in_other = sighting_errors(view, b);
  double sum = 0.0;
  for (std::size_t i = 0; i < in_best.size(); ++i)
    sum += std::min(glm::distance(in_best[i], in_other[i]), 1e6);
  return sum / double(in_best.size());
}

// Marks the cameras that another solve as good as the best puts elsewhere.
std::vector<bool> ambiguous_cameras(const SolveInput& input,
                                    const std::vector<SolvedSeed>& solved) {
  std::vector<bool> ambiguous(input.cameras(), false);
  const BundleState& best = solved.front().state;
  const CrownView crown{crown_point(best),
                        0.25 * std::min(input.lens.width_px, input.lens.height_px)};
  for (const SolvedSeed& seed : solved) {
    if (seed.cost > solved.front().cost + kAsGood) break;
    const auto other = beside(best, seed.state);
    for (std::size_t i = 0; i < ambiguous.size(); ++i)
      if (!other || crown_shift_px(input.problem, best, *other, int(i), crown) > kElsewhere_px)
        ambiguous[i] = true;
  }
  return ambiguous;
}

// The state of the seeds' points and, from the cameras found, of all others.
BundleState with_all_points(const SolveInput& input, const BundleState& state,
                            const std::vector<int>& chosen) {
  const Lens lens = lens_of(input.problem.family, state.intrinsics, 1, 1);
  const SeedScene scene =
      seed_scene(input.problem, state.intrinsics, lens, input.cameras(), input.points.size());
  PartialScene partial;
  partial.camera_from_world.assign(state.camera_from_world.begin(), state.camera_from_world.end());
  partial.points.resize(input.points.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    partial.points[std::size_t(chosen[i])] = state.points[i];
  for (std::size_t i = 0; i < partial.points.size(); ++i)
    if (!partial.points[i]) partial.points[i] = seed_point(scene, partial, i);
  BundleState all = completed(scene, partial);
  all.world_from_body.resize(input.bodies.size());
  return all;
}

}  // namespace

SolveStart start_solve(const SolveInput& input, std::span<const FirstPose> first_poses,
                       std::span<const PhotoSightings> photos, Progress& progress) {
  const std::vector<int> chosen = seed_points(input);
  const SolveInput few = only(input, chosen);
  const SeedScene scene =
      seed_scene(few.problem, few.problem.lens.mean, input.lens, few.cameras(), few.points.size());
  BundleProblem problem = few.problem;
  problem.bodies.clear();
  const auto solved = solve_seeds(
      problem, scene, all_seeds(few, scene, first_poses, photos, progress), kFinalLoss, progress);
  SolveStart start;
  start.seeds = int(solved.size());
  if (solved.empty()) return start;
  start.ambiguous = ambiguous_cameras(few, solved);
  start.state = with_all_points(input, solved.front().state, chosen);
  return start;
}

}  // namespace bosk
