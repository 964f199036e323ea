#include "core/calibrate/feature_poses.h"

#include <algorithm>
#include <cmath>

#include "core/calibrate/feature_pair.h"

namespace bosk {
namespace {

constexpr std::size_t kFewestPoints = 15;  // that place a camera
constexpr std::size_t kFewestInPair = 20;  // points of a pair that is worth going on from
constexpr double kLoss = 3.0;              // sigmas
constexpr double kFarOff = 6.0;            // sigmas beyond which a sighting is dropped
constexpr double kPoseError = 8.0;         // pixels, while the lens is still a guess
constexpr std::size_t kMostStarts = 3;     // pairs to begin from

// Everything known so far. Sightings that are far off stay out until their point is made anew.
struct Growing {
  BundleProblem problem;
  Lens lens;
  std::vector<double> intrinsics;
  PartialScene scene;
  bool lens_known = false;

  std::size_t placed() const {
    return std::size_t(std::count_if(scene.camera_from_world.begin(), scene.camera_from_world.end(),
                                     [](const auto& pose) { return pose.has_value(); }));
  }
  std::size_t known_points() const {
    return std::size_t(std::count_if(scene.points.begin(), scene.points.end(),
                                     [](const auto& point) { return point.has_value(); }));
  }
  SeedScene seeds() const {
    return seed_scene(problem, intrinsics, lens, scene.camera_from_world.size(),
                      scene.points.size());
  }
};

Growing begin(const std::vector<BundleSighting>& sightings, std::size_t cameras, std::size_t points,
              const Lens& lens, bool lens_known) {
  Growing growing;
  growing.lens = lens;
  growing.lens_known = lens_known;
  BundleProblem& problem = growing.problem;
  problem.family = family_of(lens);
  if (!lens_known && problem.family == LensFamily::pinhole) problem.family = LensFamily::opencv4;
  problem.sightings = sightings;
  growing.intrinsics = mrcal_intrinsics(lens, problem.family);
  problem.lens.mean = growing.intrinsics;
  for (std::size_t i = 0; i < growing.intrinsics.size(); ++i)
    problem.lens.sigma.push_back(i < 2   ? 0.5 * lens.focal_px.x
                                 : i < 4 ? 0.01 * lens.width_px
                                         : 0.2);
  growing.scene.camera_from_world.resize(cameras);
  growing.scene.points.resize(points);
  return growing;
}

void free_lens(Growing& growing) {
  std::vector<bool>& free = growing.problem.lens_free;
  free.assign(growing.intrinsics.size(), false);
  if (growing.lens_known) return;
  const std::size_t placed = growing.placed();
  free[0] = free[1] = placed >= 3;
  if (free.size() > 5) free[4] = free[5] = placed >= 5;
}

bool is_known(const Growing& growing, const BundleSighting& sighting) {
  return growing.scene.camera_from_world[std::size_t(sighting.camera)] &&
         growing.scene.points[std::size_t(sighting.point)];
}

// Bundle adjustment of what is known; what isn't takes no part.
void adjust(Growing& growing, int iterations, const Progress& progress) {
  free_lens(growing);
  BundleProblem problem = growing.problem;
  for (BundleSighting& sighting : problem.sightings)
    sighting.used = sighting.used && is_known(growing, sighting);
  BundleState state = completed(growing.seeds(), growing.scene);
  solve_bundle(problem, state, {kLoss, iterations}, progress);
  PartialScene& scene = growing.scene;
  for (std::size_t i = 0; i < scene.camera_from_world.size(); ++i)
    if (scene.camera_from_world[i]) scene.camera_from_world[i] = state.camera_from_world[i];
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.points[i]) scene.points[i] = state.points[i];
  growing.intrinsics = state.intrinsics;
  growing.lens =
      lens_of(problem.family, state.intrinsics, growing.lens.width_px, growing.lens.height_px);
}

void add_points(Growing& growing) {
  const SeedScene seeds = growing.seeds();
  for (std::size_t point = 0; point < growing.scene.points.size(); ++point)
    if (!growing.scene.points[point])
      growing.scene.points[point] = seed_point(seeds, growing.scene, point);
}

// Puts sightings that miss their point out of use, and drops points that fewer than two then see.
void drop_outliers(Growing& growing, double far_off) {
  std::vector<int> seen(growing.scene.points.size(), 0);
  const BundleState state = completed(growing.seeds(), growing.scene);
  const std::vector<glm::dvec2> errors = sighting_errors(growing.problem, state);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    BundleSighting& sighting = growing.problem.sightings[i];
    if (!is_known(growing, sighting)) continue;
    sighting.used = glm::length(errors[i]) <= far_off * sighting.sigma_px;
    seen[std::size_t(sighting.point)] += sighting.used;
  }
  for (std::size_t point = 0; point < seen.size(); ++point)
    if (seen[point] < 2) growing.scene.points[point].reset();
  for (BundleSighting& sighting : growing.problem.sightings)
    if (!growing.scene.points[std::size_t(sighting.point)]) sighting.used = true;
}

std::optional<int> next_camera(const Growing& growing, const std::vector<bool>& tried) {
  const SeedScene seeds = growing.seeds();
  std::optional<int> best;
  std::size_t most = kFewestPoints - 1;
  for (std::size_t camera = 0; camera < seeds.cameras(); ++camera) {
    if (growing.scene.camera_from_world[camera] || tried[camera]) continue;
    const std::size_t known = pose_sightings(seeds, growing.scene, camera).size();
    if (known <= most) continue;
    most = known;
    best = int(camera);
  }
  return best;
}

void refine(Growing& growing, int iterations, const Progress& progress) {
  adjust(growing, iterations, progress);
  drop_outliers(growing, 2.0 * kFarOff);
  add_points(growing);
  drop_outliers(growing, kFarOff);
}

void grow(Growing& growing, Progress& progress) {
  std::vector<bool> tried(growing.scene.camera_from_world.size(), false);
  while (const auto camera = next_camera(growing, tried)) {
    progress.check();
    tried[std::size_t(*camera)] = true;
    const auto pose =
        pose_by_points(growing.seeds(), growing.scene, *camera, kPoseError, kFewestPoints);
    if (!pose) continue;
    growing.scene.camera_from_world[std::size_t(*camera)] = pose;
    progress.advance();
    add_points(growing);
    refine(growing, 8, progress);
    tried.assign(tried.size(), false);
  }
  for (int round = 0; round < 3; ++round) refine(growing, 15, progress);
}

bool start_from(const FeaturePair& pair, Growing& growing, const Progress& progress) {
  growing.scene.camera_from_world[std::size_t(pair.first)] = RigidTransform{};
  growing.scene.camera_from_world[std::size_t(pair.second)] = pair.second_from_first;
  add_points(growing);
  drop_outliers(growing, 2.0 * kFarOff);
  refine(growing, 10, progress);
  return growing.known_points() >= kFewestInPair;
}

FeaturePoses result_of(const Growing& growing) {
  FeaturePoses poses{growing.lens, growing.scene.camera_from_world, growing.scene.points, {}};
  for (const BundleSighting& sighting : growing.problem.sightings)
    poses.agrees.push_back(sighting.used && is_known(growing, sighting));
  return poses;
}

// A camera grown badly drags few points along; so the most placed cameras win, then the most
// points.
bool is_better(const Growing& a, const Growing& b) {
  return std::pair(a.placed(), a.known_points()) > std::pair(b.placed(), b.known_points());
}

}  // namespace

FeaturePoses place_by_features(const std::vector<BundleSighting>& sightings, std::size_t cameras,
                               std::size_t points, const Lens& lens, bool lens_known,
                               Progress& progress) {
  const Growing nothing = begin(sightings, cameras, points, lens, lens_known);
  std::vector<FeaturePair> pairs = starting_pairs(nothing.seeds(), progress);
  if (pairs.size() > kMostStarts) pairs.resize(kMostStarts);
  Growing best = nothing;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    progress.begin("Placing photos by features", cameras, 0.8, 1.0);
    Growing growing = nothing;
    if (!start_from(pairs[i], growing, progress)) continue;
    grow(growing, progress);
    if (is_better(growing, best)) best = growing;
    if (best.placed() == cameras) break;
  }
  return result_of(best);
}

}  // namespace bosk
