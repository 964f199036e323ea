#include "core/calibrate/diagnosis_lens.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace bosk {
namespace {

constexpr double kFarOff = 0.1;       // relative, of a guess
constexpr double kWeak = 0.02;        // relative, one sigma of a focal length
constexpr double kBetterCost = 40.0;  // by which another focal length must fit better
constexpr double kOther = 0.005;      // relative, by which it must differ

std::string pixels(double focal_px) { return number_text(focal_px, 0) + " px"; }

// Else the first guess was nobody's word, and says nothing when it was far off.
bool has_exif(std::span<const PhotoSightings> photos) {
  return std::any_of(photos.begin(), photos.end(),
                     [](const PhotoSightings& photo) { return photo.exif_focal_px.has_value(); });
}

std::optional<std::string> free_lens_doubt(const Solution& solution, const SolveQuestion& question,
                                           const BundleCovariance& covariance) {
  const double focal_px = solution.state.intrinsics[0];
  const double guess_px = question.lens.lens.focal_px.x;
  const double sigma_px = std::sqrt(covariance.aligned_lens_and_camera(0)(0, 0));
  if (sigma_px > kWeak * focal_px)
    return "the photos tell the focal length to " + number_text(100.0 * sigma_px / focal_px, 1) +
           " % only: photograph a board with the same lens, or add markers nearer and farther "
           "away";
  if (has_exif(question.photos) && std::abs(focal_px / guess_px - 1.0) > kFarOff)
    return "the photos say a focal length of " + pixels(focal_px) + ", and the first guess was " +
           pixels(guess_px) +
           ": their EXIF is wrong, or they were cropped or scaled; what the "
           "photos say is used";
  return std::nullopt;
}

std::optional<std::string> known_lens_doubt(const Solution& solution, const Progress& progress) {
  BundleProblem problem = solution.input.problem;
  const double cost = bundle_cost(problem, solution.state, solution.loss);
  for (std::size_t i = 0; i < 2; ++i) problem.lens_free[i] = true;
  BundleState state = solution.state;
  const double free_cost = solve_bundle(problem, state, {solution.loss, 20}, progress);
  const double ratio = state.intrinsics[0] / solution.state.intrinsics[0];
  if (cost - free_cost < kBetterCost || std::abs(ratio - 1.0) < kOther) return std::nullopt;
  return "the known lens has a focal length of " + pixels(solution.state.intrinsics[0]) +
         ", and the photos fit better with " + pixels(state.intrinsics[0]) +
         ": calibrate the lens at this zoom setting, or leave it free";
}

}  // namespace

std::optional<std::string> lens_doubt(const Solution& solution, const SolveQuestion& question,
                                      const BundleCovariance& covariance,
                                      const Progress& progress) {
  if (question.lens.known) return known_lens_doubt(solution, progress);
  return free_lens_doubt(solution, question, covariance);
}

}  // namespace bosk
