#include "core/calibrate/lens_seed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

namespace bosk {
namespace {

constexpr std::size_t kFewestCorners = 6;
constexpr double kFocalSeeds[] = {0.6, 0.85, 1.2, 1.7, 2.5, 4.0};  // of the longer side
constexpr double kLeastFocal = 0.2, kMostFocal = 20.0;             // of the longer side, believable

struct Pairs {
  std::vector<cv::Point3f> on_board;
  std::vector<cv::Point2f> in_picture;
};

Pairs pairs_of(const LensProblem& problem, std::size_t board) {
  Pairs pairs;
  const auto corners = problem.board(board);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].z <= 0.0) continue;
    const int column = int(i) % problem.shape.columns, row = int(i) / problem.shape.columns;
    const glm::dvec3 at = corner_in_board(problem.shape, column, row);
    pairs.on_board.emplace_back(float(at.x), float(at.y), 0.0f);
    pairs.in_picture.emplace_back(float(corners[i].x), float(corners[i].y));
  }
  return pairs;
}

// Zhang's estimate; none where the boards' views don't determine it.
std::optional<double> zhang_focal(const LensProblem& problem) {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> in_picture;
  for (std::size_t board = 0; board < problem.boards; ++board) {
    Pairs pairs = pairs_of(problem, board);
    if (pairs.on_board.size() < kFewestCorners) continue;
    on_board.push_back(std::move(pairs.on_board));
    in_picture.push_back(std::move(pairs.in_picture));
  }
  if (on_board.empty()) return std::nullopt;
  try {
    const cv::Mat camera =
        cv::initCameraMatrix2D(on_board, in_picture, {problem.width_px, problem.height_px}, 1.0);
    return camera.at<double>(0, 0);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
}

std::vector<double> focal_candidates(const LensProblem& problem) {
  const double longer = std::max(problem.width_px, problem.height_px);
  std::vector<double> focals;
  if (const auto zhang = zhang_focal(problem))
    if (*zhang > kLeastFocal * longer && *zhang < kMostFocal * longer) focals.push_back(*zhang);
  for (const double factor : kFocalSeeds) focals.push_back(factor * longer);
  return focals;
}

LensState plain_lens(const LensProblem& problem, double focal_px) {
  LensState state;
  state.intrinsics = {
      focal_px, focal_px, 0.5 * (problem.width_px - 1), 0.5 * (problem.height_px - 1), 0.0, 0.0,
      0.0,      0.0};
  return state;
}

double median_error(const LensState& state, const LensProblem& problem) {
  const std::vector<glm::dvec2> errors = corner_errors(state, problem);
  std::vector<double> lengths;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (problem.pool[i].z > 0.0) lengths.push_back(glm::length(errors[i]));
  if (lengths.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

std::optional<LensState> with_poses(LensState state, const LensProblem& problem) {
  for (std::size_t board = 0; board < problem.boards; ++board) {
    const auto pose = board_pose_seen(state, problem, board);
    if (!pose) return std::nullopt;
    state.camera_from_board.push_back(*pose);
  }
  return state;
}

}  // namespace

std::optional<mrcal_pose_t> board_pose_seen(const LensState& state, const LensProblem& problem,
                                            std::size_t board) {
  const Pairs pairs = pairs_of(problem, board);
  if (pairs.on_board.size() < kFewestCorners) return std::nullopt;
  const cv::Matx33d camera(state.intrinsics[0], 0.0, state.intrinsics[2], 0.0, state.intrinsics[1],
                           state.intrinsics[3], 0.0, 0.0, 1.0);
  const std::vector<double> terms(state.intrinsics.begin() + 4, state.intrinsics.end());
  cv::Vec3d turn, shift;
  try {
    if (!cv::solvePnP(pairs.on_board, pairs.in_picture, camera, terms, turn, shift, false,
                      cv::SOLVEPNP_IPPE))
      return std::nullopt;
    cv::solvePnPRefineLM(pairs.on_board, pairs.in_picture, camera, terms, turn, shift);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  mrcal_pose_t pose{};
  for (int axis = 0; axis < 3; ++axis) {
    pose.r.xyz[axis] = turn[axis];
    pose.t.xyz[axis] = shift[axis];
    if (!std::isfinite(turn[axis]) || !std::isfinite(shift[axis])) return std::nullopt;
  }
  return pose;
}

std::optional<LensState> lens_seed(const LensProblem& problem) {
  std::optional<LensState> best;
  double best_error = std::numeric_limits<double>::infinity();
  for (const double focal_px : focal_candidates(problem)) {
    const auto state = with_poses(plain_lens(problem, focal_px), problem);
    const double error =
        state ? median_error(*state, problem) : std::numeric_limits<double>::infinity();
    if (error < best_error) {
      best = state;
      best_error = error;
    }
  }
  return best;
}

}  // namespace bosk
