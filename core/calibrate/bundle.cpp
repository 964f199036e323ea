#include "core/calibrate/bundle.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <optional>

#include "core/calibrate/bundle_loss.h"
#include "core/calibrate/bundle_normal.h"
#include "core/calibrate/bundle_project.h"
#include "core/calibrate/bundle_rows.h"

namespace bosk {
namespace {

constexpr double kFirstDamping = 1e-4, kMostDamping = 1e8;
constexpr double kSettled = 1e-7;  // relative gain of a step below which the solve is done

std::optional<BundleState> stepped(const NormalEquations& equations, const BundleState& state,
                                   double damping, const Progress& progress) {
  const ReducedSystem system = reduced(equations, damping, progress);
  const Eigen::LLT<Eigen::MatrixXd> factor(system.matrix);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd dense = factor.solve(-system.gradient);
  if (!dense.allFinite()) return std::nullopt;
  std::vector<Eigen::Vector3d> points(state.points.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const EliminatedPoint& point = equations.points[i];
    Eigen::Vector3d pull = point.gradient;
    for (const auto& [offset, value] : point.couples)
      pull += value.transpose() * dense.segment(offset, value.rows());
    points[i] = -(system.own_inverse[i] * pull);
  }
  return changed(state, equations.layout, dense, points);
}

// Damps more until a step gains; false when none does.
bool improve(const BundleProblem& problem, BundleState& state, double& cost, double& damping,
             double loss_scale, const Progress& progress) {
  const NormalEquations equations = normal_equations(problem, state, loss_scale, progress);
  cost = equations.cost;
  for (; damping < kMostDamping; damping *= 10.0) {
    progress.check();
    const std::optional<BundleState> next = stepped(equations, state, damping, progress);
    if (!next) continue;
    const double next_cost = bundle_cost(problem, *next, loss_scale);
    if (!(next_cost < cost)) continue;
    const bool settled = cost - next_cost <= kSettled * cost;
    state = *next;
    cost = next_cost;
    damping = std::max(damping / 10.0, 1e-12);
    return !settled;
  }
  return false;
}

}  // namespace

double solve_bundle(const BundleProblem& problem, BundleState& state, const BundleRound& round,
                    const Progress& progress) {
  double damping = kFirstDamping, cost = bundle_cost(problem, state, round.loss_scale);
  for (int i = 0; i < round.most_iterations; ++i)
    if (!improve(problem, state, cost, damping, round.loss_scale, progress)) break;
  return cost;
}

double bundle_cost(const BundleProblem& problem, const BundleState& state, double loss_scale) {
  const std::vector<glm::dvec2> errors = sighting_errors(problem, state);
  double cost = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const BundleSighting& sighting = problem.sightings[i];
    if (!sighting.used) continue;
    const glm::dvec2 sigmas = errors[i] / sighting.sigma_px;
    const double squared = std::min(glm::dot(sigmas, sigmas), kBehind);
    cost += robust_loss(squared, loss_scale).cost;
  }
  for_each_row(problem, state, layout_of(problem, state),
               [&](const Row& row) { cost += row_cost(row, loss_scale); });
  return cost;
}

std::vector<glm::dvec2> sighting_errors(const BundleProblem& problem, const BundleState& state) {
  std::vector<glm::dvec2> errors;
  errors.reserve(problem.sightings.size());
  for (const auto group : by_camera(problem)) {
    const ProjectedSightings projected = project_sightings(problem, state, group, false);
    for (std::size_t i = 0; i < group.size(); ++i) {
      const glm::dvec2 predicted(projected.pixel[i].x, projected.pixel[i].y);
      errors.push_back(projected.in_front[i] ? predicted - group[i].pixel
                                             : glm::dvec2(kLeastSquares));
    }
  }
  return errors;
}

}  // namespace bosk
