#include "core/calibrate/solve_steps.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/calibrate/diagnosis_photo.h"
#include "core/calibrate/uncertainty.h"

namespace bosk {
namespace {

// Fewest cameras of which a solve can tell anything.
constexpr std::size_t kFewestCameras = 3;

// Sightings' noise in their own sigmas, from the median so that mistakes don't count.
double median_noise(const Solution& solution) {
  std::vector<double> sigmas = sighting_sigmas(solution);
  if (sigmas.empty()) return 1.0;
  constexpr double kMedianOfUnitNoise = 1.1774;  // radial, two axes: sqrt(2 ln 2)
  const auto middle = sigmas.begin() + long(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  const double equations = 2.0 * double(sigmas.size());
  const double freedom =
      std::max(0.1 * equations, double(redundancy(solution.input.problem, solution.state)));
  return *middle / kMedianOfUnitNoise * std::sqrt(equations / freedom);
}

struct CameraFit {
  int fitting = 0, all = 0;
};

std::vector<CameraFit> camera_fits(const Solution& solution) {
  std::vector<CameraFit> fits(solution.input.cameras());
  const std::vector<double> sigmas = sighting_sigmas(solution);
  for (std::size_t i = 0; i < sigmas.size(); ++i) {
    CameraFit& fit = fits[std::size_t(solution.input.problem.sightings[i].camera)];
    fit.fitting += sigmas[i] < solution.loss ? 1 : 0;
    ++fit.all;
  }
  return fits;
}

std::vector<KnownSighting> known_sightings(const Solution& solution, int camera) {
  std::vector<KnownSighting> result;
  for (const BundleSighting& sighting : solution.input.problem.sightings) {
    if (sighting.camera != camera) continue;
    const auto point = std::size_t(sighting.point);
    result.push_back({solution.input.points[point], solution.state.points[point], sighting.pixel,
                      sighting.sigma_px});
  }
  return result;
}

// Cameras that settled on a wrong sighting are placed anew where that fits more right ones.
void reconsider(const BundleProblem& problem, Solution& solution, const Progress& progress) {
  repair(problem, lens_of(problem.family, solution.state.intrinsics, 1, 1), solution.loss,
         solution.state, progress);
  solve_bundle(problem, solution.state, {solution.loss, 30}, progress);
}

// What EXIF says of the photo's focal length, relative to the median of all.
std::optional<double> exif_focal_ratio(std::span<const PhotoSightings> photos, std::size_t photo) {
  std::vector<double> focal_px;
  for (const PhotoSightings& other : photos)
    if (other.exif_focal_px) focal_px.push_back(*other.exif_focal_px);
  if (!photos[photo].exif_focal_px || focal_px.size() < 3) return std::nullopt;
  std::sort(focal_px.begin(), focal_px.end());
  return *photos[photo].exif_focal_px / focal_px[focal_px.size() / 2];
}

std::string reason_of(const Solution& solution, const SolveQuestion& question, int camera,
                      const CameraFit& fit) {
  const Lens lens = lens_of(solution.input.problem.family, solution.state.intrinsics,
                            solution.input.lens.width_px, solution.input.lens.height_px);
  const auto photo = solution.input.photo_of_camera[std::size_t(camera)];
  if (2 * fit.fitting >= fit.all)
    return "has only " + std::to_string(fit.fitting) + " of " + std::to_string(fit.all) +
           " sightings that fit the other photos: correct them or mark more points in it";
  return why_photo_disagrees(known_sightings(solution, camera), lens, 1.5 * solution.loss,
                             exif_focal_ratio(question.photos, photo));
}

// The state for an input with fewer photos and points than `before`.
BundleState carried_over(const Solution& before, const SolveInput& input) {
  std::map<std::size_t, RigidTransform> poses;
  for (std::size_t i = 0; i < before.input.cameras(); ++i)
    poses[before.input.photo_of_camera[i]] = before.state.camera_from_world[i];
  std::map<std::string, glm::dvec3> places;
  for (std::size_t i = 0; i < before.input.points.size(); ++i)
    places[before.input.points[i]] = before.state.points[i];
  BundleState state;
  state.intrinsics = before.state.intrinsics;
  for (const std::size_t photo : input.photo_of_camera)
    state.camera_from_world.push_back(poses.at(photo));
  for (const std::string& point : input.points) state.points.push_back(places.at(point));
  state.world_from_body.resize(input.bodies.size());
  return state;
}

// Leaves out the photos that `refused` gives a reason for.
void solve_without(Solution& solution, const SolveQuestion& question,
                   std::vector<std::string> refused, const Progress& progress) {
  SolveInput input = solve_input(question.photos, question.survey, question.lens, question.options,
                                 std::move(refused));
  solution.state = carried_over(solution, input);
  solution.input = std::move(input);
  if (solution.input.cameras() >= kFewestCameras) settle(solution, progress);
}

// The problem with only its sightings and lens.
BundleProblem without_rows(const BundleProblem& problem) {
  BundleProblem result;
  result.family = problem.family;
  result.lens_free = problem.lens_free;
  result.lens = problem.lens;
  result.sightings = problem.sightings;
  return result;
}

// Uses what lies within the loss; a point that fewer than two photos are left to see isn't used.
void judge_sightings(Solution& solution) {
  const std::vector<double> sigmas = sighting_sigmas(solution);
  auto& sightings = solution.input.problem.sightings;
  std::vector<int> seen(solution.input.points.size(), 0);
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    sightings[i].used = sigmas[i] < solution.loss;
    seen[std::size_t(sightings[i].point)] += sightings[i].used ? 1 : 0;
  }
  for (BundleSighting& sighting : sightings)
    if (seen[std::size_t(sighting.point)] < 2) sighting.used = false;
}

void judge_rows(Solution& solution) {
  const auto& points = solution.state.points;
  for (LengthRow& row : solution.input.problem.lengths) {
    const double length = glm::distance(points[std::size_t(row.from)], points[std::size_t(row.to)]);
    row.used = std::abs(length - row.length) < kFinalLoss * row.sigma;
  }
  for (CoordinateRow& row : solution.input.problem.coordinates)
    row.used =
        std::abs(points[std::size_t(row.point)][row.axis] - row.value) < kFinalLoss * row.sigma;
}

std::vector<std::string> poor_photos(const Solution& solution, const SolveQuestion& question) {
  std::vector<std::string> refused = solution.input.refused;
  std::vector<CameraFit> fits(solution.input.cameras());
  for (const BundleSighting& sighting : solution.input.problem.sightings) {
    fits[std::size_t(sighting.camera)].fitting += sighting.used ? 1 : 0;
    ++fits[std::size_t(sighting.camera)].all;
  }
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (fits[i].fitting < question.options.fewest_sightings)
      refused[solution.input.photo_of_camera[i]] = reason_of(solution, question, int(i), fits[i]);
  return refused;
}

void solve_in_world(Solution& solution, const Progress& progress) {
  BundleProblem& problem = solution.input.problem;
  solution.determined = place_in_world(problem, solution.state);
  problem.pinned = solution.determined.free;
  if (problem.has_rows()) {
    solve_bundle(problem, solution.state, {60.0, 10}, progress);
    solve_bundle(problem, solution.state, {20.0, 10}, progress);
  }
  solve_bundle(problem, solution.state, {solution.loss, 20}, progress);
  reconsider(problem, solution, progress);
}

}  // namespace

std::vector<double> sighting_sigmas(const Solution& solution) {
  const auto& sightings = solution.input.problem.sightings;
  const auto errors = sighting_errors(solution.input.problem, solution.state);
  std::vector<double> sigmas;
  for (std::size_t i = 0; i < errors.size(); ++i)
    sigmas.push_back(glm::length(errors[i]) / sightings[i].sigma_px);
  return sigmas;
}

void settle(Solution& solution, const Progress& progress) {
  constexpr double kMostNoise = 20.0;
  const BundleProblem problem = without_rows(solution.input.problem);
  solve_bundle(problem, solution.state, {std::max(30.0, solution.loss), 10}, progress);
  solve_bundle(problem, solution.state, {std::max(12.0, solution.loss), 10}, progress);
  solve_bundle(problem, solution.state, {solution.loss, 30}, progress);
  for (int round = 0; round < 3; ++round) {
    const double loss = kFinalLoss * std::clamp(median_noise(solution), 1.0, kMostNoise);
    if (loss < 1.3 * solution.loss) break;
    solution.loss = loss;
    solve_bundle(problem, solution.state, {4.0 * loss, 15}, progress);
    solve_bundle(problem, solution.state, {loss, 30}, progress);
  }
  reconsider(problem, solution, progress);
}

bool leave_out_photos(Solution& solution, const SolveQuestion& question, Progress& progress) {
  for (int round = 0; round < 4; ++round) {
    progress.check();
    const std::vector<CameraFit> fits = camera_fits(solution);
    std::vector<std::string> refused = solution.input.refused;
    std::size_t bad = 0;
    for (std::size_t i = 0; i < fits.size(); ++i) {
      if (2 * fits[i].fitting >= fits[i].all &&
          fits[i].fitting >= question.options.fewest_sightings)
        continue;
      progress.check();
      refused[solution.input.photo_of_camera[i]] = reason_of(solution, question, int(i), fits[i]);
      ++bad;
    }
    if (bad == 0) return true;
    if (2 * bad > fits.size()) return false;
    solve_without(solution, question, std::move(refused), progress);
    if (solution.input.cameras() < kFewestCameras) return false;
  }
  return true;
}

bool finish(Solution& solution, const SolveQuestion& question, Progress& progress) {
  for (int round = 0; round < 4; ++round) {
    solve_in_world(solution, progress);
    judge_sightings(solution);
    judge_rows(solution);
    const std::vector<std::string> refused = poor_photos(solution, question);
    if (refused == solution.input.refused) break;
    solve_without(solution, question, refused, progress);
    if (solution.input.cameras() < kFewestCameras) return false;
  }
  solve_bundle(solution.input.problem, solution.state, {kLeastSquares, 20}, progress);
  judge_sightings(solution);
  judge_rows(solution);
  // What was left out may have been all that held the world
  solution.determined = determined_by(solution.input.problem, solution.state);
  solution.input.problem.pinned = solution.determined.free;
  solve_bundle(solution.input.problem, solution.state, {kLeastSquares, 30}, progress);
  return true;
}

}  // namespace bosk
