#include "core/calibrate/lens_bundle.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bosk {
namespace {

constexpr double kMarkBeyond = 4.0, kActBeyond = 5.0;  // standard deviations: mrcal's k0 and k1

double median_sigma(std::span<const BoardView* const> views) {
  std::vector<double> sigmas;
  for (const BoardView* view : views)
    for (const BoardCorner& corner : view->corners) sigmas.push_back(corner.sigma_px);
  if (sigmas.empty()) return 1.0;
  const auto middle = sigmas.begin() + std::ptrdiff_t(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  return *middle;
}

std::vector<mrcal_observation_board_t> observations(std::size_t boards) {
  std::vector<mrcal_observation_board_t> result(boards);
  for (std::size_t i = 0; i < boards; ++i) result[i] = {{0, -1}, int(i)};
  return result;
}

mrcal_problem_selections_t selections(const Freed& freed, LensFamily family) {
  mrcal_problem_selections_t result{};
  result.do_optimize_intrinsics_core = freed.core;
  result.do_optimize_intrinsics_distortions = freed.distortion && distortion_count(family) > 0;
  result.do_optimize_frames = true;
  result.do_optimize_calobject_warp = freed.warp;
  result.do_apply_regularization = freed.core || freed.distortion;
  return result;
}

}  // namespace

LensProblem lens_problem(std::span<const BoardView* const> views, const BoardShape& shape) {
  assert(!views.empty());
  LensProblem problem{shape, views[0]->width_px, views[0]->height_px, views.size(), {}};
  problem.pool.assign(views.size() * problem.corners_of_board(), mrcal_point(0.0, 0.0, -1.0));
  const double typical = median_sigma(views);
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const BoardCorner& corner : views[i]->corners) {
      auto& entry = problem.board(i)[std::size_t(corner.row * shape.columns + corner.column)];
      entry = mrcal_point(corner.pixel.x, corner.pixel.y, typical / corner.sigma_px);
    }
  return problem;
}

LensProblem part_of(const LensProblem& problem, const std::vector<std::size_t>& boards) {
  LensProblem part{problem.shape, problem.width_px, problem.height_px, boards.size(), {}};
  for (const std::size_t board : boards) {
    const auto corners = problem.board(board);
    part.pool.insert(part.pool.end(), corners.begin(), corners.end());
  }
  return part;
}

LensState enlarged(const LensState& state, LensFamily family) {
  assert(distortion_count(family) >= distortion_count(state.family));
  LensState result = state;
  result.family = family;
  result.intrinsics.resize(std::size_t(4 + distortion_count(family)), 0.0);
  return result;
}

LensState part_of(const LensState& state, const std::vector<std::size_t>& boards) {
  LensState part{state.family, state.intrinsics, {}, state.warp_m};
  for (const std::size_t board : boards)
    part.camera_from_board.push_back(state.camera_from_board[board]);
  return part;
}

void solve_lens(LensState& state, const LensProblem& problem, const Freed& freed) {
  assert(state.camera_from_board.size() == problem.boards);
  const mrcal_lensmodel_t model = mrcal_model(state.family);
  const mrcal_problem_constants_t constants{0.01, 1000.0};  // of points, of which there are none
  const int size[] = {problem.width_px, problem.height_px};
  const auto seen = observations(problem.boards);
  std::vector<mrcal_point3_t> pool = problem.pool;  // mrcal may write to it
  mrcal_optimize(nullptr, 0, nullptr, 0, state.intrinsics.data(), nullptr,
                 state.camera_from_board.data(), nullptr, &state.warp_m, 1, 0, int(problem.boards),
                 0, 0, seen.data(), nullptr, int(problem.boards), 0, pool.data(), &model, size,
                 selections(freed, state.family), &constants, problem.shape.square_m,
                 problem.shape.columns, problem.shape.rows, false, false);
}

mrcal_point3_t board_point(const LensState& state, const BoardShape& shape, int column, int row) {
  const double u = 2.0 * column / (shape.columns - 1) - 1.0;
  const double v = 2.0 * row / (shape.rows - 1) - 1.0;
  const double z = state.warp_m.x2 * (1.0 - u * u) + state.warp_m.y2 * (1.0 - v * v);
  return mrcal_point(column * shape.square_m, row * shape.square_m, z);
}

std::vector<glm::dvec2> corner_errors(const LensState& state, const LensProblem& problem) {
  const mrcal_lensmodel_t model = mrcal_model(state.family);
  std::vector<glm::dvec2> errors(problem.pool.size(), glm::dvec2(0.0));
  for (std::size_t board = 0; board < problem.boards; ++board) {
    const RigidTransform camera_from_board = transform_of(state.camera_from_board[board]);
    for (std::size_t i = 0; i < problem.corners_of_board(); ++i) {
      const mrcal_point3_t& seen = problem.board(board)[i];
      if (!is_seen(seen)) continue;
      const int column = int(i) % problem.shape.columns, row = int(i) / problem.shape.columns;
      const mrcal_point3_t on_board = board_point(state, problem.shape, column, row);
      const glm::dvec3 p = camera_from_board * glm::dvec3(on_board.x, on_board.y, on_board.z);
      const mrcal_point3_t in_camera = mrcal_point(p.x, p.y, p.z);
      mrcal_point2_t pixel{};
      mrcal_project(&pixel, nullptr, nullptr, &in_camera, 1, &model, state.intrinsics.data());
      errors[board * problem.corners_of_board() + i] = {pixel.x - seen.x, pixel.y - seen.y};
    }
  }
  return errors;
}

std::size_t mark_outliers(LensProblem& problem, const std::vector<glm::dvec2>& errors) {
  double sum = 0.0, largest = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double weight = problem.pool[i].z;
    if (weight <= 0.0) continue;
    const glm::dvec2 weighted = weight * glm::abs(errors[i]);
    sum += glm::dot(weighted, weighted);
    largest = std::max({largest, weighted.x, weighted.y});
    ++count;
  }
  const double sigma = std::sqrt(sum / (2.0 * double(std::max<std::size_t>(count, 1))));
  if (!(largest > kActBeyond * sigma)) return 0;
  std::size_t marked = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    double& weight = problem.pool[i].z;
    const glm::dvec2 weighted = weight * glm::abs(errors[i]);
    if (weight <= 0.0 || std::max(weighted.x, weighted.y) <= kMarkBeyond * sigma) continue;
    weight = -1.0;
    ++marked;
  }
  return marked;
}

double corner_sigma(const LensProblem& problem, const std::vector<glm::dvec2>& errors,
                    std::size_t parameters) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double weight = problem.pool[i].z;
    if (weight <= 0.0) continue;
    sum += weight * weight * glm::dot(errors[i], errors[i]);
    count += 2;
  }
  return count > parameters ? std::sqrt(sum / double(count - parameters)) : 0.0;
}

double rms_px(std::span<const mrcal_point3_t> pool, std::span<const glm::dvec2> errors) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (pool[i].z <= 0.0) continue;
    sum += glm::dot(errors[i], errors[i]);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / (2.0 * double(count))) : 0.0;
}

}  // namespace bosk
