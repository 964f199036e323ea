#include "core/calibrate/uncertainty.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/calibrate/bundle_project.h"

namespace bosk {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

Matrix3d eigen(const glm::dmat3& m) {
  Matrix3d result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result(row, column) = m[column][row];
  return result;
}

Vector3d eigen(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

BundleProblem with_noise(BundleProblem problem, double noise) {
  for (BundleSighting& sighting : problem.sightings) sighting.sigma_px *= noise;
  return problem;
}

// Directions that no equation sees get a variance of about 1 / kNothing instead of none.
MatrixXd inverse_of(MatrixXd matrix) {
  constexpr double kNothing = 1e-12;
  const auto identity = MatrixXd::Identity(matrix.rows(), matrix.cols());
  Eigen::LLT<MatrixXd> factor(matrix);
  for (double damping = kNothing; factor.info() != Eigen::Success && damping < 1.0;
       damping *= 10.0) {
    MatrixXd damped = matrix;
    damped.diagonal() *= 1.0 + damping;
    factor.compute(damped);
  }
  return factor.solve(identity);
}

}  // namespace

BundleCovariance::BundleCovariance(const BundleProblem& problem, const BundleState& state,
                                   double noise, const MatrixXd& pins, const Progress& progress)
    : state_(state),
      equations_(normal_equations(with_noise(problem, noise), state, kLeastSquares, progress)) {
  if (pins.cols() > 0) equations_.dense.selfadjointView<Eigen::Lower>().rankUpdate(pins, kPinned);
  ReducedSystem system = reduced(equations_, 0.0, progress);
  dense_ = inverse_of(std::move(system.matrix));
  own_inverse_ = std::move(system.own_inverse);
}

MatrixXd BundleCovariance::lens_and_camera(int camera) const {
  const int lens = int(equations_.layout.lens.size()), begin = equations_.layout.camera(camera);
  MatrixXd result(lens + 6, lens + 6);
  result << dense_.topLeftCorner(lens, lens), dense_.block(0, begin, lens, 6),
      dense_.block(begin, 0, 6, lens), dense_.block(begin, begin, 6, 6);
  return result;
}

Matrix3d BundleCovariance::centre(int camera) const {
  const Matrix3d turn = eigen(state_.camera_from_world[std::size_t(camera)].rotation);
  const int begin = equations_.layout.camera(camera) + 3;
  return turn.transpose() * dense_.block<3, 3>(begin, begin) * turn;
}

// A point's change is its kept rows of the dense part, or -own^-1 W^T times the dense change; what
// it doesn't couple with is left out.
std::vector<EliminatedPoint::Couple> BundleCovariance::change_by_dense(int point) const {
  const auto index = std::size_t(point);
  const int kept = equations_.layout.kept_offset[index];
  if (kept >= 0) return {{kept, Matrix3d::Identity()}};
  std::vector<EliminatedPoint::Couple> couples = equations_.points[index].couples;
  for (auto& [offset, value] : couples) value = -value * own_inverse_[index];
  return couples;
}

Matrix3d BundleCovariance::own(int point) const {
  const auto index = std::size_t(point);
  if (equations_.layout.kept_offset[index] >= 0) return Matrix3d::Zero();
  return own_inverse_[index];
}

Matrix3d BundleCovariance::points(int first, int second) const {
  Matrix3d result = first == second ? own(first) : Matrix3d::Zero();
  for (const auto& [row, by_row] : change_by_dense(first))
    for (const auto& [column, by_column] : change_by_dense(second))
      result += by_row.transpose() * dense_.block(row, column, by_row.rows(), by_column.rows()) *
                by_column;
  return result;
}

double BundleCovariance::distance_sigma(int first, int second) const {
  const glm::dvec3 apart =
      glm::normalize(state_.points[std::size_t(second)] - state_.points[std::size_t(first)]);
  const Matrix3d cross = points(first, second);
  const Matrix3d both = points(first, first) + points(second, second) - cross - cross.transpose();
  return std::sqrt(std::max(0.0, eigen(apart).dot(both * eigen(apart))));
}

double BundleCovariance::scale_sigma() const {
  const glm::dvec3 mean = mean_centre(state_);
  const auto count = double(state_.camera_from_world.size());
  std::vector<glm::dvec3> outward;
  glm::dvec3 sum(0.0);
  double distance = 0.0;
  for (const RigidTransform& camera : state_.camera_from_world) {
    const glm::dvec3 arm = inverse(camera).translation - mean;
    outward.push_back(glm::normalize(arm));
    sum += outward.back();
    distance += glm::length(arm);
  }
  Eigen::VectorXd by = Eigen::VectorXd::Zero(dense_.rows());
  for (std::size_t i = 0; i < outward.size(); ++i)
    by.segment<3>(equations_.layout.camera(int(i)) + 3) =
        -eigen(state_.camera_from_world[i].rotation * (outward[i] - sum / count)) / distance;
  return std::sqrt(std::max(0.0, by.dot(dense_ * by)));
}

std::vector<glm::dvec3> crown_ring(const BundleState& state, int camera, const CrownView& view) {
  const RigidTransform& pose = state.camera_from_world[std::size_t(camera)];
  const RigidTransform world_from_camera = inverse(pose);
  const double radius = view.ring_px / state.intrinsics[0] * (pose * view.crown).z;
  std::vector<glm::dvec3> ring{view.crown};
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.7853981633974483 * i;
    ring.push_back(view.crown + radius * (world_from_camera.rotation *
                                          glm::dvec3(std::cos(angle), std::sin(angle), 0.0)));
  }
  return ring;
}

namespace {

// Derivatives of the ring's pixels by the free intrinsics, then the camera.
std::vector<MatrixXd> ring_derivatives(const BundleProblem& problem, const BundleState& state,
                                       int camera, const CrownView& view) {
  BundleProblem sight;
  sight.family = problem.family;
  sight.lens_free = problem.lens_free;
  BundleState there = state;
  there.points = crown_ring(state, camera, view);
  for (int i = 0; i < int(there.points.size()); ++i)
    sight.sightings.push_back({camera, i, glm::dvec2(0.0), 1.0, true});
  const ProjectedSightings seen = project_sightings(sight, there, sight.sightings, true);
  std::vector<MatrixXd> derivatives;
  for (std::size_t i = 0; i < there.points.size(); ++i)
    derivatives.push_back(pixel_by_lens_and_camera(sight, there, seen, i));
  return derivatives;
}

// B^T B of the derivatives B of all rings by the dense part.
MatrixXd ring_normal(const BundleProblem& problem, const BundleState& state,
                     const BundleLayout& layout, const CrownView& view) {
  MatrixXd normal = MatrixXd::Zero(layout.dense_size, layout.dense_size);
  const int lens = int(layout.lens.size());
  for (int camera = 0; camera < int(state.camera_from_world.size()); ++camera) {
    const int begin = layout.camera(camera);
    for (const MatrixXd& by : ring_derivatives(problem, state, camera, view)) {
      const MatrixXd own = by.transpose() * by;
      normal.topLeftCorner(lens, lens) += own.topLeftCorner(lens, lens);
      normal.block(0, begin, lens, 6) += own.topRightCorner(lens, 6);
      normal.block(begin, 0, 6, lens) += own.bottomLeftCorner(6, lens);
      normal.block(begin, begin, 6, 6) += own.bottomRightCorner(6, 6);
    }
  }
  return normal;
}

}  // namespace

// Of all changes that differ by moves of the world, the one whose ring pixels B x are least has
// G^T B^T B x = 0, G being the moves: so B^T B G is pinned.
BundleCovariance crown_covariance(const BundleProblem& problem, const BundleState& state,
                                  double noise, const CrownView& view, const Progress& progress) {
  BundleProblem shape = problem;
  shape.pinned.clear();
  const BundleLayout layout = layout_of(problem, state);
  MatrixXd moves(layout.dense_size, 7);
  for (int i = 0; i < 7; ++i) {
    GaugeMove move{};
    move[std::size_t(i)] = 1.0;
    moves.col(i) = gauge_direction(layout, state, move, view.crown).normalized();
  }
  const MatrixXd pins = ring_normal(problem, state, layout, view) * moves;
  const Eigen::HouseholderQR<MatrixXd> factor(pins);
  const MatrixXd basis = factor.householderQ() * MatrixXd::Identity(pins.rows(), 7);
  return {shape, state, noise, basis, progress};
}

double crown_sigma_px(const BundleCovariance& covariance, const BundleProblem& problem,
                      const BundleState& state, int camera, const CrownView& view) {
  const MatrixXd both = covariance.lens_and_camera(camera);
  const std::vector<MatrixXd> derivatives = ring_derivatives(problem, state, camera, view);
  double sum = 0.0;
  for (const MatrixXd& by : derivatives) sum += (by * both * by.transpose()).trace();
  return std::sqrt(sum / double(derivatives.size()));
}

int redundancy(const BundleProblem& problem, const BundleState& state) {
  int equations = 0, lens = 0;
  std::vector<bool> seen(state.points.size(), false);
  for (const BundleSighting& sighting : problem.sightings) {
    if (!sighting.used) continue;
    equations += 2;
    seen[std::size_t(sighting.point)] = true;
  }
  for (const bool free : problem.lens_free) lens += free ? 1 : 0;
  const int points = int(std::count(seen.begin(), seen.end(), true));
  const int strong_lens = std::min(lens, 1);  // the others have priors that hold them
  return equations - 6 * int(state.camera_from_world.size()) - 3 * points + 7 - strong_lens;
}

double noise_factor(const BundleProblem& problem, const BundleState& state) {
  constexpr double kBelieved = 10.0;  // degrees of freedom that the sightings' own sigma is worth
  const std::vector<glm::dvec2> errors = sighting_errors(problem, state);
  double chi_square = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!problem.sightings[i].used) continue;
    const glm::dvec2 sigmas = errors[i] / problem.sightings[i].sigma_px;
    chi_square += glm::dot(sigmas, sigmas);
  }
  const double freedom = std::max(0, redundancy(problem, state));
  return std::sqrt((kBelieved + chi_square) / (kBelieved + freedom));
}

}  // namespace bosk
