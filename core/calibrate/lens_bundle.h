#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/calibrate/lens_solve.h"
#include "core/calibrate/mrcal_lens.h"

// Private to this folder: the header shows mrcal.
namespace bosk {

inline mrcal_point3_t mrcal_point(double x, double y, double z) {
  mrcal_point3_t point{};
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}

// Boards that one lens saw, as mrcal takes them: the lens stands at the origin and each photo has a
// board pose of its own (mrcal's "frame").
struct LensProblem {
  BoardShape shape;
  int width_px = 0, height_px = 0;
  std::size_t boards = 0;
  // For each board each corner by row, then by column: its pixel and, in z, its weight: the median
  // sigma over its own. -1: not seen, or an outlier.
  std::vector<mrcal_point3_t> pool;

  std::size_t corners_of_board() const { return std::size_t(shape.columns * shape.rows); }
  std::span<mrcal_point3_t> board(std::size_t i) {
    return std::span(pool).subspan(i * corners_of_board(), corners_of_board());
  }
  std::span<const mrcal_point3_t> board(std::size_t i) const {
    return std::span(pool).subspan(i * corners_of_board(), corners_of_board());
  }
};
// Whether an entry of the pool was seen, be it an outlier.
inline bool is_seen(const mrcal_point3_t& corner) {
  return corner.z > 0.0 || corner.x != 0.0 || corner.y != 0.0;
}
LensProblem lens_problem(std::span<const BoardView* const> views, const BoardShape& shape);
// The boards whose numbers are given, in that order.
LensProblem part_of(const LensProblem& problem, const std::vector<std::size_t>& boards);

struct LensState {
  LensFamily family = LensFamily::opencv4;
  std::vector<double> intrinsics;  // as in mrcal_lens.h
  std::vector<mrcal_pose_t> camera_from_board;
  // How far the middle of the board's edges stands out: z += x (1 - u^2) + y (1 - v^2), u and v
  // from -1 to 1 over the corners.
  mrcal_calobject_warp_t warp_m{};
};
// The same lens with the terms of a larger family, which start at 0.
LensState enlarged(const LensState& state, LensFamily family);
LensState part_of(const LensState& state, const std::vector<std::size_t>& boards);

// Which of a state's parts a solve may change; boards always move.
struct Freed {
  bool core = true, distortion = true, warp = false;
};

// Moves `state` to the least squares of the weighted corner errors (mrcal: dogleg, at most 300
// steps). A solve can't be stopped; 40 boards take about 0.1 s.
void solve_lens(LensState& state, const LensProblem& problem, const Freed& freed);

// Predicted minus seen for each corner of the pool, outliers too; 0 where none was seen.
std::vector<glm::dvec2> corner_errors(const LensState& state, const LensProblem& problem);

// The point of the board, warped, in the board's frame.
mrcal_point3_t board_point(const LensState& state, const BoardShape& shape, int column, int row);

// Marks corners as outliers by mrcal's rule: where any weighted error exceeds five standard
// deviations along an axis, all over four go. Returns how many were marked. The rule is run here
// since mrcal's own loop can't be stopped and prints each round.
std::size_t mark_outliers(LensProblem& problem, const std::vector<glm::dvec2>& errors);

// Standard deviation of a corner of median sigma along one axis, from the errors left.
double corner_sigma(const LensProblem& problem, const std::vector<glm::dvec2>& errors,
                    std::size_t parameters);

// Over both axes of the corners that count; 0 without any.
double rms_px(std::span<const mrcal_point3_t> pool, std::span<const glm::dvec2> errors);

}  // namespace bosk
