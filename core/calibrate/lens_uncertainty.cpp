#include "core/calibrate/lens_uncertainty.h"

#include <algorithm>
#include <cmath>

namespace bosk {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Matrix2x3 = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using Matrix2X = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kMostSigma_px = 1000.0;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d result;
  result << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return result;
}

struct Projection {
  Matrix2x3 by_point;
  Matrix2X by_intrinsics;
};

Projection projection_of(const Vector3d& point, LensFamily family,
                         const std::vector<double>& intrinsics) {
  const mrcal_lensmodel_t model = mrcal_model(family);
  const mrcal_point3_t p = mrcal_point(point.x(), point.y(), point.z());
  mrcal_point2_t pixel{};
  mrcal_point3_t by_point[2]{};
  Projection result{{}, Matrix2X(2, Eigen::Index(intrinsics.size()))};
  mrcal_project(&pixel, by_point, result.by_intrinsics.data(), &p, 1, &model, intrinsics.data());
  for (int axis = 0; axis < 2; ++axis)
    for (int i = 0; i < 3; ++i) result.by_point(axis, i) = by_point[axis].xyz[i];
  return result;
}

// What the corners of one board say: normal equations of what all share (lens, warp) and of its
// pose (a turn about the camera's axes, then a shift).
struct BoardNormals {
  MatrixXd shared, across, pose;  // k x k, k x 6, 6 x 6
};

// Derivatives of one corner by lens and, where `shared` leaves room, warp; and by the pose.
struct CornerRows {
  Matrix2X shared;
  Eigen::Matrix<double, 2, 6> pose;
};

CornerRows corner_rows(const LensState& state, const BoardShape& shape, const Matrix3d& turn,
                       const Vector3d& shift, int column, int row, Eigen::Index shared) {
  const mrcal_point3_t at = board_point(state, shape, column, row);
  const Vector3d turned = turn * Vector3d(at.x, at.y, at.z);
  const Projection projection = projection_of(turned + shift, state.family, state.intrinsics);
  const Eigen::Index lens = projection.by_intrinsics.cols();
  CornerRows rows{Matrix2X::Zero(2, shared), {}};
  rows.shared.leftCols(lens) = projection.by_intrinsics;
  if (shared > lens) {
    const double u = 2.0 * column / (shape.columns - 1) - 1.0;
    const double v = 2.0 * row / (shape.rows - 1) - 1.0;
    rows.shared.col(lens) = projection.by_point * turn.col(2) * (1.0 - u * u);
    rows.shared.col(lens + 1) = projection.by_point * turn.col(2) * (1.0 - v * v);
  }
  rows.pose.leftCols<3>() = -projection.by_point * cross_matrix(turned);
  rows.pose.rightCols<3>() = projection.by_point;
  return rows;
}

Matrix3d eigen_rotation(const RigidTransform& transform) {
  Matrix3d result;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) result(row, column) = transform.rotation[column][row];
  return result;
}

BoardNormals normals_of(const LensState& state, const LensProblem& problem, std::size_t board,
                        Eigen::Index shared) {
  const RigidTransform pose = transform_of(state.camera_from_board[board]);
  const Matrix3d turn = eigen_rotation(pose);
  const Vector3d shift(pose.translation.x, pose.translation.y, pose.translation.z);
  BoardNormals normals{MatrixXd::Zero(shared, shared), MatrixXd::Zero(shared, 6),
                       MatrixXd::Zero(6, 6)};
  const auto corners = problem.board(board);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].z <= 0.0) continue;
    const int column = int(i) % problem.shape.columns, row = int(i) / problem.shape.columns;
    const CornerRows rows = corner_rows(state, problem.shape, turn, shift, column, row, shared);
    const double square = corners[i].z * corners[i].z;
    normals.shared += square * rows.shared.transpose() * rows.shared;
    normals.across += square * rows.shared.transpose() * rows.pose;
    normals.pose += square * rows.pose.transpose() * rows.pose;
  }
  return normals;
}

// Squared weights of mrcal's regularisation of each shared term: its residuals are weight * term
// (distortion) and weight * (centre - middle of the frame), so a state whose terms are all 1 and
// whose centre is 1 px off shows them.
Eigen::VectorXd regularisation(const LensState& state, const LensProblem& problem,
                               Eigen::Index shared) {
  const mrcal_lensmodel_t model = mrcal_model(state.family);
  mrcal_problem_selections_t selections{};
  selections.do_optimize_intrinsics_core = true;
  selections.do_optimize_intrinsics_distortions = true;
  selections.do_apply_regularization = true;
  std::vector<double> probe = state.intrinsics;
  probe[2] = 0.5 * (problem.width_px - 1) + 1.0;
  probe[3] = 0.5 * (problem.height_px - 1) + 1.0;
  std::fill(probe.begin() + 4, probe.end(), 1.0);
  const int boards = int(problem.boards), columns = problem.shape.columns,
            rows = problem.shape.rows;
  std::vector<mrcal_observation_board_t> seen(problem.boards);
  for (int i = 0; i < boards; ++i) seen[std::size_t(i)] = {{0, -1}, i};
  const int states = mrcal_num_states(1, 0, boards, 0, 0, boards, selections, &model);
  const int measured =
      mrcal_num_measurements(boards, 0, columns, rows, 1, 0, boards, 0, 0, selections, &model);
  std::vector<double> packed(std::size_t(states), 0.0), x(std::size_t(measured), 0.0);
  const int size[] = {problem.width_px, problem.height_px};
  const mrcal_problem_constants_t constants{0.01, 1000.0};
  mrcal_optimizer_callback(packed.data(), int(packed.size() * sizeof(double)), x.data(),
                           int(x.size() * sizeof(double)), nullptr, probe.data(), nullptr,
                           state.camera_from_board.data(), nullptr, nullptr, 1, 0, boards, 0, 0,
                           seen.data(), nullptr, boards, 0, problem.pool.data(), &model, size,
                           selections, &constants, problem.shape.square_m, columns, rows, false);
  Eigen::VectorXd squared = Eigen::VectorXd::Zero(shared);
  const std::size_t first = std::size_t(boards * columns * rows * 2);
  const std::size_t terms = state.intrinsics.size() - 4;
  for (std::size_t i = 0; i < terms; ++i)
    squared[Eigen::Index(4 + i)] = x[first + i] * x[first + i];
  for (std::size_t i = 0; i < 2 && first + terms + i < x.size(); ++i)
    squared[Eigen::Index(2 + i)] = x[first + terms + i] * x[first + terms + i];
  return squared;
}

// The inverse of a symmetric matrix that may be singular but for rounding: scaled to a diagonal of
// 1, with a ridge of 1e-13.
MatrixXd inverse_of(const MatrixXd& symmetric) {
  const Eigen::VectorXd scale = symmetric.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  MatrixXd scaled = scale.asDiagonal() * symmetric * scale.asDiagonal();
  scaled.diagonal().array() += 1e-13;
  const MatrixXd identity = MatrixXd::Identity(scaled.rows(), scaled.cols());
  return scale.asDiagonal() * scaled.ldlt().solve(identity) * scale.asDiagonal();
}

}  // namespace

double LensCovariance::focal_sigma() const {
  return std::sqrt(std::max(0.0, covariance(0, 0))) / std::abs(intrinsics[0]);
}

LensCovariance lens_covariance(const LensState& state, const LensProblem& problem, bool warp,
                               double sigma_px) {
  const auto lens = Eigen::Index(state.intrinsics.size());
  const Eigen::Index shared = lens + (warp ? 2 : 0);
  MatrixXd reduced = MatrixXd::Zero(shared, shared);
  MatrixXd turn_by_shared = MatrixXd::Zero(3, shared);  // how the mean turn follows lens and warp
  Matrix3d own_turn = Matrix3d::Zero();                 // its noise besides
  const double share = 1.0 / double(problem.boards);
  for (std::size_t board = 0; board < problem.boards; ++board) {
    const BoardNormals normals = normals_of(state, problem, board, shared);
    const MatrixXd pose_inverse = inverse_of(normals.pose);
    reduced += normals.shared - normals.across * pose_inverse * normals.across.transpose();
    turn_by_shared -= share * (pose_inverse * normals.across.transpose()).topRows(3);
    own_turn += share * share * pose_inverse.topLeftCorner<3, 3>();
  }
  MatrixXd with_regularisation = reduced;
  with_regularisation.diagonal() += regularisation(state, problem, shared);
  const MatrixXd inverse = inverse_of(with_regularisation);
  const MatrixXd spread = inverse * reduced * inverse;
  MatrixXd whole(shared + 3, shared + 3);
  whole.topLeftCorner(shared, shared) = spread;
  whole.topRightCorner(shared, 3) = spread * turn_by_shared.transpose();
  whole.bottomLeftCorner(3, shared) = turn_by_shared * spread;
  whole.bottomRightCorner(3, 3) = turn_by_shared * spread * turn_by_shared.transpose() + own_turn;
  whole *= sigma_px * sigma_px;
  LensCovariance result{state.family, state.intrinsics, MatrixXd(lens + 3, lens + 3), {}};
  result.covariance.topLeftCorner(lens, lens) = whole.topLeftCorner(lens, lens);
  result.covariance.topRightCorner(lens, 3) = whole.topRightCorner(shared, 3).topRows(lens);
  result.covariance.bottomLeftCorner(3, lens) = whole.bottomLeftCorner(3, shared).leftCols(lens);
  result.covariance.bottomRightCorner(3, 3) = whole.bottomRightCorner(3, 3);
  if (warp)
    result.warp_sigma_m = {std::sqrt(std::max(0.0, whole(lens, lens))),
                           std::sqrt(std::max(0.0, whole(lens + 1, lens + 1)))};
  return result;
}

Image<float> projection_sigma(const LensCovariance& lens, int width_px, int height_px, int columns,
                              int rows) {
  const Lens own = lens_of(lens.family, lens.intrinsics, width_px, height_px);
  const auto terms = Eigen::Index(lens.intrinsics.size());
  Image<float> sigma(columns, rows, float(kMostSigma_px));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 pixel((column + 0.5) / columns * width_px - 0.5,
                             (row + 0.5) / rows * height_px - 0.5);
      const auto ray = camera_from_pixel(own, pixel);
      if (!ray) continue;
      const Vector3d direction(ray->x, ray->y, ray->z);
      const Projection projection = projection_of(direction, lens.family, lens.intrinsics);
      Matrix2X by_all(2, terms + 3);
      by_all.leftCols(terms) = projection.by_intrinsics;
      by_all.rightCols(3) = -projection.by_point * cross_matrix(direction);
      const double variance = (by_all * lens.covariance * by_all.transpose()).trace() / 2.0;
      sigma(column, row) = float(std::min(kMostSigma_px, std::sqrt(std::max(0.0, variance))));
    }
  return sigma;
}

}  // namespace bosk
