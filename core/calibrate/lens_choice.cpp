#include "core/calibrate/lens_choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bosk {
namespace {

constexpr double kSameError =
    0.01;  // relative difference of squared errors that nobody would notice

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

double weighted_square(std::span<const mrcal_point3_t> pool, std::span<const glm::dvec2> errors) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (pool[i].z <= 0.0) continue;
    sum += pool[i].z * pool[i].z * glm::dot(errors[i], errors[i]);
    count += 2;
  }
  return count > 0 ? sum / double(count) : 0.0;
}

struct Fold {
  std::vector<std::size_t> kept, held_out;
};

Fold fold_of(std::size_t boards, std::size_t folds, std::size_t number) {
  Fold fold;
  for (std::size_t board = 0; board < boards; ++board)
    (board % folds == number ? fold.held_out : fold.kept).push_back(board);
  return fold;
}

// Whether `simple` is as good as `best`, judged by their differences board by board.
bool within_noise(const std::vector<double>& simple, const std::vector<double>& best) {
  std::vector<double> differences(simple.size());
  for (std::size_t i = 0; i < simple.size(); ++i) differences[i] = simple[i] - best[i];
  const double worse = mean(differences);
  double spread = 0.0;
  for (const double difference : differences) spread += (difference - worse) * (difference - worse);
  const double count = double(differences.size());
  const double standard_error = std::sqrt(spread / (count * std::max(1.0, count - 1.0)));
  return worse <= std::max(standard_error, kSameError * mean(best));
}

bool sees_whole_frame(const LensState& state, int width_px, int height_px) {
  constexpr int kSteps = 8;
  const Lens lens = lens_of(state.family, state.intrinsics, width_px, height_px);
  for (int j = 0; j <= kSteps; ++j)
    for (int i = 0; i <= kSteps; ++i) {
      const glm::dvec2 share(double(i) / kSteps, double(j) / kSteps);
      if (!camera_from_pixel(lens, share * glm::dvec2(width_px, height_px) - 0.5)) return false;
    }
  return true;
}

}  // namespace

void cross_validate(LensCandidate& candidate, const LensProblem& problem, int folds, bool warp,
                    Progress& progress) {
  const std::size_t count = std::min(problem.boards, std::size_t(folds));
  candidate.held_out.assign(problem.boards, 0.0);
  for (std::size_t number = 0; number < count; ++number) {
    const Fold fold = fold_of(problem.boards, count, number);
    LensState trained = part_of(candidate.state, fold.kept);
    solve_lens(trained, part_of(problem, fold.kept), {true, true, warp});
    candidate.focals_px.push_back(trained.intrinsics[0]);
    LensState tested = part_of(candidate.state, fold.held_out);
    tested.intrinsics = trained.intrinsics;
    tested.warp_m = trained.warp_m;
    const LensProblem unseen = part_of(problem, fold.held_out);
    solve_lens(tested, unseen, {false, false, false});
    const std::vector<glm::dvec2> errors = corner_errors(tested, unseen);
    const std::size_t corners = problem.corners_of_board();
    for (std::size_t i = 0; i < fold.held_out.size(); ++i)
      candidate.held_out[fold.held_out[i]] =
          weighted_square(unseen.board(i), std::span(errors).subspan(i * corners, corners));
    progress.advance();
  }
}

std::size_t simplest_within_noise(const std::vector<LensCandidate>& candidates, int width_px,
                                  int height_px) {
  assert(!candidates.empty());
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (mean(candidates[i].held_out) < mean(candidates[best].held_out)) best = i;
  std::vector<std::size_t> equals;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (i == best || within_noise(candidates[i].held_out, candidates[best].held_out))
      equals.push_back(i);
  for (const std::size_t i : equals)
    if (sees_whole_frame(candidates[i].state, width_px, height_px)) return i;
  return equals.front();
}

double held_out_rms(const LensCandidate& candidate) {
  return candidate.held_out.empty() ? 0.0 : std::sqrt(mean(candidate.held_out));
}

double jackknife_focal_sigma(const LensCandidate& candidate) {
  const double folds = double(candidate.focals_px.size());
  if (folds < 2.0) return 0.0;
  const double middle = mean(candidate.focals_px);
  double squares = 0.0;
  for (const double focal : candidate.focals_px) squares += (focal - middle) * (focal - middle);
  return std::sqrt((folds - 1.0) / folds * squares) / middle;
}

}  // namespace bosk
