#include "core/calibrate/seed_solve.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/calibrate/bundle_loss.h"

namespace bosk {
namespace {

constexpr double kHopeless = 3.0;    // times the best cost half way
constexpr double kSmallCost = 20.0;  // per camera, below which no seed is hopeless

double cost_of(const std::vector<glm::dvec2>& errors, const BundleProblem& problem,
               const std::vector<std::size_t>& which, double loss_scale) {
  double cost = 0.0;
  for (const std::size_t i : which) {
    if (!problem.sightings[i].used) continue;
    const glm::dvec2 sigmas = errors[i] / problem.sightings[i].sigma_px;
    cost += robust_loss(std::min(glm::dot(sigmas, sigmas), kBehind), loss_scale).cost;
  }
  return cost;
}

// A cost above which a camera or point isn't where it should be: a quarter of what it can cost.
bool fits_badly(double cost, std::size_t sightings, double loss_scale) {
  return cost > 0.25 * double(sightings) * loss_scale * loss_scale;
}

// A camera with few sightings is doubted for one mistake: another pose may make it two right ones.
bool is_doubtful(double cost, std::size_t sightings, double loss_scale) {
  constexpr std::size_t kFew = 40;
  return sightings <= kFew ? cost > loss_scale * loss_scale
                           : fits_badly(cost, sightings, loss_scale);
}

PartialScene all_known(const BundleState& state) {
  return {{state.camera_from_world.begin(), state.camera_from_world.end()},
          {state.points.begin(), state.points.end()}};
}

void repair_cameras(const SeedScene& scene, double loss_scale, BundleState& state,
                    const Progress& progress) {
  const auto errors = sighting_errors(*scene.problem, state);
  const PartialScene partial = all_known(state);
  for (std::size_t i = 0; i < scene.cameras(); ++i) {
    const double cost = cost_of(errors, *scene.problem, scene.of_camera[i], loss_scale);
    if (!is_doubtful(cost, scene.of_camera[i].size(), loss_scale)) continue;
    progress.check();
    const auto sightings = pose_sightings(scene, partial, i);
    const auto poses = place_camera(sightings, loss_scale);
    if (!poses.empty() && poses.front().cost < 0.9 * cost)
      state.camera_from_world[i] = poses.front().camera_from_world;
  }
}

void repair_points(const SeedScene& scene, double loss_scale, BundleState& state) {
  auto errors = sighting_errors(*scene.problem, state);
  const PartialScene partial = all_known(state);
  BundleState tried = state;
  for (std::size_t i = 0; i < scene.points(); ++i)
    if (const auto place = seed_point(scene, partial, i)) tried.points[i] = *place;
  const auto tried_errors = sighting_errors(*scene.problem, tried);
  for (std::size_t i = 0; i < scene.points(); ++i) {
    const double cost = cost_of(errors, *scene.problem, scene.of_point[i], loss_scale);
    if (fits_badly(cost, scene.of_point[i].size(), loss_scale) &&
        cost_of(tried_errors, *scene.problem, scene.of_point[i], loss_scale) < cost)
      state.points[i] = tried.points[i];
  }
}

Lens lens_in(const BundleProblem& problem, const BundleState& state) {
  return lens_of(problem.family, state.intrinsics, 1, 1);
}

void begin_solve(const BundleProblem& problem, SolvedSeed& seed, Progress& progress) {
  const BundleProblem fixed = with_lens_stage(problem, 0);
  solve_bundle(fixed, seed.state, {120.0, 8}, progress);
  solve_bundle(fixed, seed.state, {60.0, 6}, progress);
  repair(problem, lens_in(problem, seed.state), 60.0, seed.state, progress);
  seed.cost = solve_bundle(fixed, seed.state, {30.0, 8}, progress);
  progress.advance();
}

void end_solve(const BundleProblem& problem, SolvedSeed& seed, double final_loss,
               Progress& progress) {
  const BundleProblem focal = with_lens_stage(problem, 1);
  repair(problem, lens_in(problem, seed.state), 30.0, seed.state, progress);
  solve_bundle(focal, seed.state, {30.0, 10}, progress);
  solve_bundle(focal, seed.state, {std::max(16.0, final_loss), 8}, progress);
  repair(problem, lens_in(problem, seed.state), std::max(16.0, final_loss), seed.state, progress);
  solve_bundle(problem, seed.state, {std::max(8.0, final_loss), 10}, progress);
  repair(problem, lens_in(problem, seed.state), std::max(8.0, final_loss), seed.state, progress);
  seed.cost = solve_bundle(problem, seed.state, {final_loss, 40}, progress);
  progress.advance();
}

void sort_by_cost(std::vector<SolvedSeed>& seeds) {
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const SolvedSeed& a, const SolvedSeed& b) { return a.cost < b.cost; });
}

// Half way the best few go on, and those not far behind.
void drop_hopeless(std::vector<SolvedSeed>& seeds, std::size_t cameras) {
  constexpr std::size_t kAlways = 3, kAtMost = 8;
  sort_by_cost(seeds);
  const double bound = kHopeless * std::max(seeds.front().cost, kSmallCost * double(cameras));
  while (seeds.size() > kAlways && (seeds.back().cost > bound || seeds.size() > kAtMost))
    seeds.pop_back();
}

}  // namespace

void repair(const BundleProblem& problem, const Lens& lens, double loss_scale, BundleState& state,
            const Progress& progress) {
  const SeedScene scene = seed_scene(problem, state.intrinsics, lens,
                                     state.camera_from_world.size(), state.points.size());
  repair_points(scene, loss_scale, state);
  repair_cameras(scene, loss_scale, state, progress);
}

BundleProblem with_lens_stage(const BundleProblem& problem, int count) {
  BundleProblem result = problem;
  for (std::size_t i = count == 0 ? 0 : 2; count < 2 && i < result.lens_free.size(); ++i)
    result.lens_free[i] = false;
  return result;
}

std::vector<SolvedSeed> solve_seeds(const BundleProblem& problem, const SeedScene& scene,
                                    std::vector<Seed> seeds, double final_loss,
                                    Progress& progress) {
  std::vector<SolvedSeed> solved;
  for (const Seed& seed : seeds) solved.push_back({seed.from, completed(scene, seed.scene), 0.0});
  if (solved.empty()) return solved;
  progress.begin("Cameras, first guesses", 2 * solved.size(), 0.1, 0.7);
  tbb::parallel_for(std::size_t(0), solved.size(),
                    [&](std::size_t i) { begin_solve(problem, solved[i], progress); });
  drop_hopeless(solved, scene.cameras());
  tbb::parallel_for(std::size_t(0), solved.size(),
                    [&](std::size_t i) { end_solve(problem, solved[i], final_loss, progress); });
  sort_by_cost(solved);
  return solved;
}

}  // namespace bosk
