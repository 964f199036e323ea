#include "core/calibrate/lens_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/calibrate/lens_seed.h"

namespace bosk {
namespace {

constexpr int kMostRounds = 12;
constexpr std::size_t kFewestBoards = 3;
constexpr double kMisfit = 3.0;              // times the median board's error
constexpr double kLeastMisfit = 1.0 / 6000;  // of the frame's diagonal: 0.3 px of 1800

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// For each board the error that three quarters of its corners stay under: a few gross corners don't
// move it, a bent board does.
std::vector<double> board_errors(const LensState& state, const LensProblem& problem) {
  const std::vector<glm::dvec2> errors = corner_errors(state, problem);
  std::vector<double> result;
  for (std::size_t board = 0; board < problem.boards; ++board) {
    std::vector<double> lengths{};
    const auto corners = problem.board(board);
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (corners[i].z > 0.0)
        lengths.push_back(glm::length(errors[board * problem.corners_of_board() + i]));
    result.push_back(lengths.empty() ? 0.0 : quantile(lengths, 0.75));
  }
  return result;
}

std::optional<std::size_t> worst_misfit(const LensState& state, const LensProblem& problem) {
  if (problem.boards <= kFewestBoards) return std::nullopt;
  const std::vector<double> errors = board_errors(state, problem);
  const double diagonal = std::hypot(double(problem.width_px), double(problem.height_px));
  const double limit = std::max(kMisfit * quantile(errors, 0.5), kLeastMisfit * diagonal);
  const auto worst = std::max_element(errors.begin(), errors.end());
  if (*worst <= limit) return std::nullopt;
  return std::size_t(worst - errors.begin());
}

void leave_out(LensFit& fit, std::size_t number) {
  fit.misfits.push_back(fit.boards[number]);
  std::vector<std::size_t> kept(fit.boards.size());
  std::iota(kept.begin(), kept.end(), std::size_t(0));
  kept.erase(kept.begin() + std::ptrdiff_t(number));
  fit.problem = part_of(fit.problem, kept);
  fit.state = part_of(fit.state, kept);
  fit.boards.erase(fit.boards.begin() + std::ptrdiff_t(number));
}

// Solves until neither a board nor a corner stands out.
void settle(LensFit& fit, const Freed& freed, Progress& progress) {
  solve_lens(fit.state, fit.problem, freed);
  for (int round = 0; round < kMostRounds + int(fit.boards.size()); ++round) {
    progress.check();
    if (const auto misfit = worst_misfit(fit.state, fit.problem)) {
      leave_out(fit, *misfit);
    } else if (mark_outliers(fit.problem, corner_errors(fit.state, fit.problem)) == 0) {
      return;
    }
    solve_lens(fit.state, fit.problem, freed);
  }
}

// All boards and corners again, under the fit's lens: what a poorer lens couldn't explain gets
// another chance. Boards without a pose stay out.
void restore(LensFit& fit, const LensProblem& whole) {
  std::vector<std::size_t> boards;
  std::vector<mrcal_pose_t> poses;
  fit.misfits.clear();
  for (std::size_t board = 0; board < whole.boards; ++board) {
    const auto kept = std::find(fit.boards.begin(), fit.boards.end(), board);
    const auto pose = kept == fit.boards.end()
                          ? board_pose_seen(fit.state, whole, board)
                          : fit.state.camera_from_board[std::size_t(kept - fit.boards.begin())];
    if (pose) {
      boards.push_back(board);
      poses.push_back(*pose);
    } else {
      fit.misfits.push_back(board);
    }
  }
  fit.boards = boards;
  fit.problem = part_of(whole, boards);
  fit.state.camera_from_board = poses;
}

// Leaves out, before any solve, the boards that miss the present lens by far.
void leave_out_misfits(LensFit& fit) {
  while (const auto misfit = worst_misfit(fit.state, fit.problem)) leave_out(fit, *misfit);
}

}  // namespace

std::optional<LensFit> fit_lens(const LensProblem& problem, LensFamily family, bool warp,
                                Progress& progress) {
  std::optional<LensState> seed = lens_seed(problem);
  if (!seed) return std::nullopt;
  LensFit fit{{}, problem, *seed, {}};
  fit.boards.resize(problem.boards);
  std::iota(fit.boards.begin(), fit.boards.end(), std::size_t(0));
  solve_lens(fit.state, fit.problem, {true, false, false});
  progress.check();
  settle(fit, {true, true, false}, progress);
  fit.state = enlarged(fit.state, family);
  settle(fit, {true, true, warp}, progress);
  restore(fit, problem);
  leave_out_misfits(fit);
  settle(fit, {true, true, warp}, progress);
  return fit;
}

}  // namespace bosk
