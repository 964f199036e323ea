#include "core/calibrate/lens_solve.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/calibrate/lens_choice.h"
#include "core/calibrate/lens_fit.h"
#include "core/calibrate/lens_seed.h"
#include "core/calibrate/lens_uncertainty.h"
#include "core/calibrate/lens_verdict.h"
#include "core/calibrate/lens_views.h"

namespace bosk {
namespace {

constexpr std::size_t kFewestBoards = 3, kFewestToChoose = 6;
constexpr int kCoverageCells = 18, kUncertaintyCells = 24;  // along the frame's longer side
constexpr double kSureWarp = 3.0;                           // sigmas

struct Named {
  LensFamily family;
  const char* name;
};
constexpr Named kFamilies[] = {{LensFamily::opencv4, "opencv4"},
                               {LensFamily::opencv5, "opencv5"},
                               {LensFamily::opencv8, "opencv8"}};

// From simple to rich: those that the options and the number of boards leave to choose from.
std::vector<Named> families_to_try(const LensOptions& options, std::size_t boards) {
  if (options.model == "auto" && boards < kFewestToChoose) return {kFamilies[0]};
  std::vector<Named> families;
  for (const Named& named : kFamilies)
    if (options.model == "auto" || options.model == named.name) families.push_back(named);
  if (families.empty())
    throw Error("no lens model is called \"" + options.model +
                "\"; give auto, opencv4, opencv5 or opencv8");
  return families;
}

std::size_t parameters(const LensState& state, bool warp) {
  return state.intrinsics.size() + 6 * state.camera_from_board.size() + (warp ? 2 : 0);
}

double sigma_of(const LensState& state, const LensProblem& problem, bool warp) {
  return corner_sigma(problem, corner_errors(state, problem), parameters(state, warp));
}

// Whether the board bends by more than its uncertainty could feign.
bool warp_is_sure(const LensFit& fit) {
  const LensCovariance lens =
      lens_covariance(fit.state, fit.problem, true, sigma_of(fit.state, fit.problem, true));
  return std::abs(fit.state.warp_m.x2) > kSureWarp * lens.warp_sigma_m.x ||
         std::abs(fit.state.warp_m.y2) > kSureWarp * lens.warp_sigma_m.y;
}

// Solves the fit's boards again with another family, from the fit's core and poses.
LensState solved_as(LensFamily family, const LensFit& fit, bool warp) {
  if (family == fit.state.family && warp) return fit.state;
  LensState state = fit.state;
  if (!warp) state.warp_m = {};
  if (family != state.family) {
    state.family = family;
    state.intrinsics.resize(4);
    state = enlarged(state, family);
  }
  solve_lens(state, fit.problem, {true, true, warp});
  return state;
}

// The chosen candidate; trials are noted.
LensCandidate choose(const LensFit& fit, const std::vector<Named>& families,
                     const LensOptions& options, bool warp, std::vector<LensTrial>& trials,
                     Progress& progress) {
  std::vector<LensCandidate> candidates;
  for (const Named& named : families) {
    candidates.push_back({solved_as(named.family, fit, warp), {}, {}});
    progress.advance();
    if (fit.problem.boards > kFewestBoards)
      cross_validate(candidates.back(), fit.problem, options.folds, warp, progress);
  }
  const std::size_t chosen =
      families.size() > 1
          ? simplest_within_noise(candidates, fit.problem.width_px, fit.problem.height_px)
          : 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const LensState& state = candidates[i].state;
    trials.push_back({families[i].name, rms_px(fit.problem.pool, corner_errors(state, fit.problem)),
                      held_out_rms(candidates[i]), i == chosen});
  }
  return candidates[chosen];
}

// Between the board's normal and the axis of the lens: a board parallel to the sensor tells nothing
// of the focal length, wherever in the picture it is.
double tilt_of(const RigidTransform& camera_from_board) {
  return std::acos(std::clamp(std::abs(camera_from_board.rotation[2].z), 0.0, 1.0));
}

// A number of columns or rows for a side, so that cells come out about square.
int cells_along(int side_px, int longer_px, int cells) {
  return std::max(3, int(std::lround(double(cells) * side_px / longer_px)));
}

// What is known when a lens has been solved.
struct Solved {
  const LensFit& fit;
  const LensState& state;
  const std::vector<std::size_t>& views;  // the number of each problem's board among all views
  std::vector<glm::dvec2> errors;
};

void note_board(LensCalibration& result, const Solved& solved, std::size_t board) {
  const LensProblem& problem = solved.fit.problem;
  const std::size_t view = solved.views[solved.fit.boards[board]];
  const std::size_t first = board * problem.corners_of_board();
  const auto errors = std::span(solved.errors).subspan(first, problem.corners_of_board());
  const auto corners = problem.board(board);
  BoardFinding& finding = result.boards[view];
  finding.used = true;
  finding.rms_px = rms_px(corners, errors);
  finding.camera_from_board = transform_of(solved.state.camera_from_board[board]);
  finding.tilt = tilt_of(finding.camera_from_board);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!is_seen(corners[i])) continue;
    const int column = int(i) % problem.shape.columns, row = int(i) / problem.shape.columns;
    const bool outlier = corners[i].z <= 0.0;
    result.residuals.push_back(
        {view, column, row, {corners[i].x, corners[i].y}, errors[i], outlier});
    finding.outliers += outlier ? 1 : 0;
  }
}

// How far a board that was left out misses the lens of the others.
void note_misfit(LensCalibration& result, const Solved& solved, const LensProblem& all,
                 std::size_t board) {
  LensProblem own = part_of(all, {board});
  BoardFinding& finding = result.boards[solved.views[board]];
  if (const auto pose = board_pose_seen(solved.state, own, 0)) {
    LensState state = solved.state;
    state.camera_from_board = {*pose};
    finding.rms_px = rms_px(own.pool, corner_errors(state, own));
    finding.camera_from_board = transform_of(*pose);
    finding.tilt = tilt_of(finding.camera_from_board);
  }
  finding.reason = "its corners miss the lens of the other photos by " +
                   number_text(finding.rms_px, 2) +
                   " px (rms): the board is bent or was moved, it was misread, or the photo is of "
                   "another camera or zoom";
}

Image<float> coverage_of(const LensProblem& problem) {
  const int longer = std::max(problem.width_px, problem.height_px);
  Image<float> coverage(cells_along(problem.width_px, longer, kCoverageCells),
                        cells_along(problem.height_px, longer, kCoverageCells));
  for (const mrcal_point3_t& corner : problem.pool) {
    if (corner.z <= 0.0) continue;
    const int x = int((corner.x + 0.5) / problem.width_px * coverage.width());
    const int y = int((corner.y + 0.5) / problem.height_px * coverage.height());
    coverage(std::clamp(x, 0, coverage.width() - 1), std::clamp(y, 0, coverage.height() - 1)) += 1;
  }
  return coverage;
}

void note_lens(LensCalibration& result, const Solved& solved, bool warp) {
  const LensProblem& problem = solved.fit.problem;
  const int width = problem.width_px, height = problem.height_px;
  result.corner_sigma_px = corner_sigma(problem, solved.errors, parameters(solved.state, warp));
  const LensCovariance covariance =
      lens_covariance(solved.state, problem, warp, result.corner_sigma_px);
  result.focal_sigma = covariance.focal_sigma();
  result.board_warp_m = {solved.state.warp_m.x2, solved.state.warp_m.y2};
  LensProfile& profile = result.profile;
  profile.lens = lens_of(solved.state.family, solved.state.intrinsics, width, height);
  profile.rms_px = rms_px(problem.pool, solved.errors);
  profile.boards = int(problem.boards);
  profile.corners = int(std::count_if(problem.pool.begin(), problem.pool.end(),
                                      [](const auto& corner) { return corner.z > 0.0; }));
  profile.coverage = coverage_of(problem);
  const int longer = std::max(width, height);
  profile.uncertainty_px =
      projection_sigma(covariance, width, height, cells_along(width, longer, kUncertaintyCells),
                       cells_along(height, longer, kUncertaintyCells));
}

// Too few boards for a solve: the best guess is a plain lens.
void note_guess(LensCalibration& result, const LensProblem& problem) {
  if (const auto seed = lens_seed(problem))
    result.profile.lens =
        lens_of(seed->family, seed->intrinsics, problem.width_px, problem.height_px);
  result.profile.boards = int(problem.boards);
}

void solve_boards(LensCalibration& result, const LensProblem& problem,
                  const std::vector<std::size_t>& views, const LensOptions& options,
                  Progress& progress) {
  const std::vector<Named> families = families_to_try(options, problem.boards);
  progress.begin("Lens from boards", 2 + families.size() * std::size_t(options.folds + 1));
  const auto fit = fit_lens(problem, families.back().family, options.board_warp, progress);
  if (!fit) throw Error("no pose explains the boards; check the number of columns and rows");
  progress.advance();
  const bool warp = options.board_warp && warp_is_sure(*fit);
  const LensCandidate chosen = choose(*fit, families, options, warp, result.trials, progress);
  const LensState& state = chosen.state;
  const Solved solved{*fit, state, views, corner_errors(state, fit->problem)};
  note_lens(result, solved, warp);
  result.focal_spread = jackknife_focal_sigma(chosen);
  for (std::size_t board = 0; board < fit->boards.size(); ++board)
    note_board(result, solved, board);
  for (const std::size_t board : fit->misfits) note_misfit(result, solved, problem, board);
  progress.advance();
}

}  // namespace

Options describe(LensOptions& options) {
  return {{"model",
           "",
           "how the lens may bend; auto asks boards that were held out",
           &options.model,
           0,
           0,
           {"auto", "opencv4", "opencv5", "opencv8"}},
          {"folds",
           "",
           "parts in which boards are held out in turn to choose the model",
           &options.folds,
           2,
           20,
           {}},
          {"board_warp",
           "",
           "let the board bend a little, alike in all photos",
           &options.board_warp,
           0,
           0,
           {}}};
}

LensCalibration calibrate_lens(std::span<const BoardView> views, const BoardShape& shape,
                               const LensOptions& options, Progress& progress) {
  check_board_shape(shape);
  LensCalibration result;
  const std::vector<std::size_t> matching = views_that_match(views, shape, result.boards);
  if (matching.empty())
    throw Error("no board of " + std::to_string(shape.columns) + " x " +
                std::to_string(shape.rows) + " inner corners was found in any of " +
                std::to_string(views.size()) +
                " photos; check the numbers (corners where four squares meet, not squares), and "
                "that the whole board with its white rim is in the picture and in focus");
  std::vector<const BoardView*> chosen;
  for (const std::size_t i : matching) chosen.push_back(&views[i]);
  const LensProblem problem = lens_problem(chosen, shape);
  if (matching.size() < kFewestBoards)
    note_guess(result, problem);
  else
    solve_boards(result, problem, matching, options, progress);
  result.profile.taken_with = chosen.front()->taken_with;
  judge_lens(result, shape);
  return result;
}

}  // namespace bosk
