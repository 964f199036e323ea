#include "core/calibrate/lens_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/calibrate/lens_seed.h"

namespace bosk {
namespace {

constexpr int kMostRounds = 12;
constexpr std::size_t kFewestBoards = 3;
constexpr double kMisfit = 3.0;  // times the median board's error
// Of the frame's diagonal: 0.3 px of 1800, below which no board is a misfit and no corner gross;
// and 3.6 px, which a lens with too few terms may miss a good corner by.
constexpr double kLeastMisfit = 1.0 / 6000, kPoorLens = 1.0 / 500;

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
        lengths.push_back(glm::length(errors[board * problem.shape.corners() + i]));
    result.push_back(lengths.empty() ? 0.0 : quantile(lengths, 0.75));
  }
  return result;
}

double diagonal_px(const LensProblem& problem) {
  return std::hypot(double(problem.width_px), double(problem.height_px));
}

// A board's error beyond which it doesn't belong to the others.
double misfit_limit(const std::vector<double>& errors, const LensProblem& problem) {
  return std::max(kMisfit * quantile(errors, 0.5), kLeastMisfit * diagonal_px(problem));
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

// Places a board anew, without its gross corners, which may have pulled its pose; they are marked.
// Whether that brings it below the limit.
bool mended(LensFit& fit, std::size_t number, double limit) {
  const auto placed =
      placed_board(fit.state, fit.problem, number, kLeastMisfit * diagonal_px(fit.problem));
  if (!placed || placed->three_quarters_px() > limit) return false;
  const auto pool = fit.problem.board(number);
  const bool changed = !std::equal(pool.begin(), pool.end(), placed->problem.pool.begin(),
                                   [](const auto& a, const auto& b) { return a.z == b.z; });
  std::copy(placed->problem.pool.begin(), placed->problem.pool.end(), pool.begin());
  fit.state.camera_from_board[number] = placed->camera_from_board;
  return changed;
}

// Mends or leaves out the board that stands out most; false where none does.
bool treat_misfit(LensFit& fit) {
  if (fit.problem.boards <= kFewestBoards) return false;
  const std::vector<double> errors = board_errors(fit.state, fit.problem);
  const double limit = misfit_limit(errors, fit.problem);
  const auto worst = std::max_element(errors.begin(), errors.end());
  if (*worst <= limit) return false;
  const auto number = std::size_t(worst - errors.begin());
  if (!mended(fit, number, limit)) leave_out(fit, number);
  return true;
}

// Solves until neither a board nor a corner stands out.
void settle(LensFit& fit, const Freed& freed, Progress& progress) {
  solve_lens(fit.state, fit.problem, freed);
  for (int round = 0; round < kMostRounds + 2 * int(fit.boards.size()); ++round) {
    progress.check();
    if (!treat_misfit(fit) &&
        mark_outliers(fit.problem, corner_errors(fit.state, fit.problem)) == 0)
      return;
    solve_lens(fit.state, fit.problem, freed);
  }
}

// All boards and corners again, placed under the fit's lens: what a poorer lens couldn't explain
// gets another chance. What misses this lens by far stays out, so that no solve is pulled by it.
void restore(LensFit& fit, const LensProblem& whole) {
  const double limit = misfit_limit(board_errors(fit.state, fit.problem), fit.problem);
  LensFit restored{{}, whole, fit.state, {}};
  restored.problem.pool.clear();
  restored.state.camera_from_board.clear();
  for (std::size_t board = 0; board < whole.boards; ++board) {
    const auto placed = placed_board(fit.state, whole, board, kPoorLens * diagonal_px(whole));
    if (!placed || placed->three_quarters_px() > limit) {
      restored.misfits.push_back(board);
      continue;
    }
    restored.boards.push_back(board);
    restored.problem.pool.insert(restored.problem.pool.end(), placed->problem.pool.begin(),
                                 placed->problem.pool.end());
    restored.state.camera_from_board.push_back(placed->camera_from_board);
  }
  restored.problem.boards = restored.boards.size();
  if (restored.boards.size() >= kFewestBoards) fit = std::move(restored);
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
  restore(fit, problem);
  fit.state = enlarged(fit.state, family);
  settle(fit, {true, true, warp}, progress);
  restore(fit, problem);
  settle(fit, {true, true, warp}, progress);
  return fit;
}

}  // namespace bosk
