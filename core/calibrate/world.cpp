#include "core/calibrate/world.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/calibrate/bundle_loss.h"
#include "core/calibrate/bundle_rows.h"
#include "core/calibrate/world_axes.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

using Matrix7 = Eigen::Matrix<double, 7, 7>;
using Vector7 = Eigen::Matrix<double, 7, 1>;

constexpr double kAlignLoss = 20.0;  // sigmas; the points aren't yet as good as the tapes
// Holds what no row tells against the rounding of its slope, which would move the world by
// millions.
constexpr double kLeastDamping = 1e-9;

// The survey alone, bodies as lengths between their points, so that only points and cameras count.
BundleProblem survey_of(const BundleProblem& problem, const BundleState& state) {
  BundleProblem survey;
  survey.lens_free.assign(state.intrinsics.size(), false);
  survey.lengths = problem.lengths;
  survey.coordinates = problem.coordinates;
  survey.plumbs = problem.plumbs;
  survey.ups = problem.ups;
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    for (std::size_t step = 1; step <= 2 && i + step < problem.bodies.size(); ++step) {
      const BodyRow &a = problem.bodies[i], &b = problem.bodies[i + step];
      if (a.body != b.body) break;
      survey.lengths.push_back(
          {a.point, b.point, glm::distance(a.in_body, b.in_body), std::sqrt(2.0) * a.sigma, true});
    }
  }
  return survey;
}

// The move's translation is in units of `unit`.
Similarity similarity_of(const Vector7& move, const glm::dvec3& centre, double unit) {
  Similarity result{std::exp(move[6]), rotation_from_rodrigues({move[3], move[4], move[5]}), {}};
  const glm::dvec3 shift(move[0], move[1], move[2]);
  result.translation = centre + unit * shift - result.scale * (result.rotation * centre);
  return result;
}

std::vector<double> survey_residuals(const BundleProblem& survey, const BundleState& state) {
  std::vector<double> residuals;
  for_each_row(survey, state, layout_of(survey, state), [&](const Row& row) {
    for (const double residual : row.residual) residuals.push_back(residual);
  });
  return residuals;
}

struct SurveyFit {
  Matrix7 normal = Matrix7::Zero();
  Vector7 gradient = Vector7::Zero();
};

// By central differences: seven numbers, a few dozen rows.
SurveyFit survey_fit(const BundleProblem& survey, const BundleState& state, double loss_scale) {
  constexpr double kStep = 1e-6;
  const glm::dvec3 centre = mean_centre(state);
  const double unit = mean_distance(state, centre);
  const std::vector<double> here = survey_residuals(survey, state);
  Eigen::MatrixXd by(here.size(), 7);
  for (int i = 0; i < 7; ++i) {
    const Vector7 step = kStep * Vector7::Unit(i);
    const auto ahead = survey_residuals(survey, moved(state, similarity_of(step, centre, unit)));
    const auto behind = survey_residuals(survey, moved(state, similarity_of(-step, centre, unit)));
    for (std::size_t row = 0; row < here.size(); ++row)
      by(Eigen::Index(row), i) = (ahead[row] - behind[row]) / (2.0 * kStep);
  }
  SurveyFit fit;
  for (std::size_t row = 0; row < here.size(); ++row) {
    const double weight = robust_loss(here[row] * here[row], loss_scale).weight;
    const Vector7 derivative = by.row(Eigen::Index(row)).transpose();
    fit.normal += weight * derivative * derivative.transpose();
    fit.gradient += weight * here[row] * derivative;
  }
  return fit;
}

double survey_cost(const BundleProblem& survey, const BundleState& state, double loss_scale) {
  double cost = 0.0;
  for (const double residual : survey_residuals(survey, state))
    cost += robust_loss(residual * residual, loss_scale).cost;
  return cost;
}

// Levenberg and Marquardt's iteration over the similarity. Returns the cost.
double align(const BundleProblem& survey, BundleState& state, double loss_scale) {
  double damping = 1e-3, cost = survey_cost(survey, state, loss_scale);
  for (int i = 0; i < 60 && damping < 1e8; ++i) {
    const SurveyFit fit = survey_fit(survey, state, loss_scale);
    Matrix7 normal = fit.normal;
    normal.diagonal().array() += damping * fit.normal.diagonal().maxCoeff() + 1e-12;
    const glm::dvec3 centre = mean_centre(state);
    const BundleState next = moved(state, similarity_of(-normal.ldlt().solve(fit.gradient), centre,
                                                        mean_distance(state, centre)));
    const double next_cost = survey_cost(survey, next, loss_scale);
    damping *= 10.0;
    if (!(next_cost < cost)) continue;
    const bool settled = cost - next_cost < 1e-9 * cost;
    state = next;
    cost = next_cost;
    damping = std::max(damping / 100.0, kLeastDamping);
    if (settled) break;
  }
  return cost;
}

double fitted_scale(const BundleProblem& survey, const BundleState& state) {
  double known = 0.0, own = 0.0;
  const auto add = [&](const glm::dvec3& apart, double length, double sigma) {
    known += glm::length(apart) * length / (sigma * sigma);
    own += glm::dot(apart, apart) / (sigma * sigma);
  };
  for (const LengthRow& row : survey.lengths)
    add(state.points[std::size_t(row.to)] - state.points[std::size_t(row.from)], row.length,
        row.sigma);
  if (own > 0.0) return known / own;
  return height_scale(survey.coordinates, state.points);
}

// Up along z, sized by the lengths, heights met on average.
BundleState begun(const BundleProblem& survey, const BundleState& state, const glm::dvec3& up,
                  double heading) {
  const glm::dmat3 turn = rotation_from_rodrigues({0.0, 0.0, heading}) * rotation_to_z(up);
  BundleState result = moved(state, {1.0, turn, glm::dvec3(0.0)});
  result = moved(result, {fitted_scale(survey, result), glm::dmat3(1.0), glm::dvec3(0.0)});
  return moved(result, {1.0, glm::dmat3(1.0), mean_coordinate_miss(survey.coordinates, result)});
}

// The state by which the surveyed points lie where they were surveyed; none for fewer than three.
std::optional<BundleState> on_surveyed(const BundleProblem& survey, const BundleState& state) {
  std::vector<glm::dvec3> source, target;
  for (const auto& [point, place] : surveyed_places(survey.coordinates)) {
    source.push_back(state.points[std::size_t(point)]);
    target.push_back(place);
  }
  if (source.size() < 3) return std::nullopt;
  try {
    return moved(state, fit_similarity(source, target));
  } catch (const Error&) {
    return std::nullopt;  // on one line: the other beginnings serve
  }
}

std::vector<BundleState> beginnings(const BundleProblem& survey, const BundleState& state) {
  std::vector<BundleState> states;
  if (const auto surveyed = on_surveyed(survey, state)) states.push_back(*surveyed);
  const bool headed = std::any_of(survey.coordinates.begin(), survey.coordinates.end(),
                                  [](const CoordinateRow& row) { return row.axis != 2; });
  for (const glm::dvec3& up : possible_ups(survey, state))
    for (int quarter = 0; quarter < (headed ? 4 : 1); ++quarter)
      states.push_back(begun(survey, state, up, 1.5707963267948966 * quarter));
  return states;
}

Determined determined_by_survey(const BundleProblem& survey, const BundleState& state) {
  const Eigen::SelfAdjointEigenSolver<Matrix7> solver(
      survey_fit(survey, state, kLeastSquares).normal);
  const double unit = mean_distance(state, mean_centre(state));
  Vector7 free_share = Vector7::Zero();
  Determined result;
  for (int i = 0; i < 7; ++i) {
    if (solver.eigenvalues()[i] * kWeakestSurvey * kWeakestSurvey > 1.0) continue;
    const Vector7 direction = solver.eigenvectors().col(i);
    free_share += direction.cwiseAbs2();
    GaugeMove move{};
    for (int k = 0; k < 7; ++k) move[std::size_t(k)] = direction[k] * (k < 3 ? unit : 1.0);
    result.free.push_back(move);
  }
  constexpr double kHardly = 0.05;
  result.place = free_share[0] < kHardly && free_share[1] < kHardly;
  result.ground = free_share[2] < kHardly;
  result.up = free_share[3] < kHardly && free_share[4] < kHardly;
  result.heading = free_share[5] < kHardly;
  result.scale = free_share[6] < kHardly;
  return result;
}

void choose_what_is_free(const BundleProblem& survey, const Determined& determined,
                         BundleState& state) {
  const bool any_coordinate = !survey.coordinates.empty();
  if (!determined.scale && !any_coordinate)
    state = moved(
        state, {1.0 / mean_distance(state, crown_point(state)), glm::dmat3(1.0), glm::dvec3(0.0)});
  if (!determined.place) {
    const glm::dvec3 crown = crown_point(state);
    state = moved(state, {1.0, glm::dmat3(1.0), {-crown.x, -crown.y, 0.0}});
  }
  if (!determined.ground && !any_coordinate)
    state = moved(state, {1.0, glm::dmat3(1.0), {0.0, 0.0, -lowest_point(state)}});
  if (!determined.heading && !determined.place) {
    const glm::dvec3 first = inverse(state.camera_from_world.front()).translation;
    const double turn = -1.5707963267948966 - std::atan2(first.y, first.x);
    state = moved(state, {1.0, rotation_from_rodrigues({0.0, 0.0, turn}), glm::dvec3(0.0)});
  }
}

void place_bodies(const BundleProblem& problem, BundleState& state) {
  for (std::size_t body = 0; body < state.world_from_body.size(); ++body) {
    std::vector<glm::dvec3> in_body, in_world;
    for (const BodyRow& row : problem.bodies) {
      if (std::size_t(row.body) != body) continue;
      in_body.push_back(row.in_body);
      in_world.push_back(state.points[std::size_t(row.point)]);
    }
    if (!in_body.empty()) state.world_from_body[body] = fit_body(in_body, in_world);
  }
}

}  // namespace

Determined place_in_world(const BundleProblem& problem, BundleState& state) {
  const BundleProblem survey = survey_of(problem, state);
  BundleState best;
  double least = kLeastSquares;
  for (BundleState& begin : beginnings(survey, state)) {
    align(survey, begin, 50.0 * kAlignLoss);
    const double cost = align(survey, begin, kAlignLoss);
    if (cost < least) best = std::move(begin);
    least = std::min(least, cost);
  }
  state = std::move(best);
  choose_what_is_free(survey, determined_by_survey(survey, state), state);
  place_bodies(problem, state);
  return determined_by_survey(survey, state);
}

Determined determined_by(const BundleProblem& problem, const BundleState& state) {
  return determined_by_survey(survey_of(problem, state), state);
}

BundleState moved(const BundleState& state, const Similarity& target_from_source) {
  BundleState result = state;
  for (RigidTransform& camera : result.camera_from_world)
    camera = moved(camera, target_from_source);
  for (glm::dvec3& point : result.points) point = target_from_source * point;
  for (RigidTransform& body : result.world_from_body)
    body = {target_from_source.rotation * body.rotation, target_from_source * body.translation};
  return result;
}

}  // namespace bosk
