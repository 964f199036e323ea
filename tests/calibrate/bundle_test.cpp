#include "core/calibrate/bundle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/calibrate/bundle_normal.h"
#include "core/calibrate/uncertainty.h"
#include "orbit.h"
#include "orbit_bundle.h"

namespace bosk {
namespace {

// A state some centimetres and milliradians off.
BundleState shaken(const BundleState& state, const BundleProblem& problem, double amount,
                   std::uint64_t seed) {
  Random random(seed);
  const BundleLayout layout = layout_of(problem, state);
  Eigen::VectorXd dense(layout.dense_size);
  for (double& value : dense) value = amount * random.normal();
  for (int i = 0; i < int(layout.lens.size()); ++i)
    dense[i] *= layout.lens[std::size_t(i)] < 4 ? 100.0 : 0.1;
  std::vector<Eigen::Vector3d> points(state.points.size());
  for (Eigen::Vector3d& point : points)
    point = amount * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  return changed(state, layout, dense, points);
}

// One of each kind of row.
OrbitBundle bundle_with_rows() {
  OrbitBundle bundle =
      orbit_bundle(make_orbit({.photos = 6, .markers = 6, .gross = 0.0, .feet = true}));
  BundleProblem& problem = bundle.problem;
  problem.lens_free.assign(problem.lens_free.size(), true);
  problem.lengths = {{0, 2, 1.7, 0.002, true}};
  problem.coordinates = {{4, 2, 1.1, 0.005, true}, {6, 0, 0.4, 0.005, true}};
  problem.plumbs = {{8, 9, 0.02}};
  problem.bodies = {{0, 10, {0.1, 0.2, 0.3}, 0.001}, {0, 11, {0.4, -0.2, 0.1}, 0.001}};
  problem.ups = {{1, glm::normalize(glm::dvec3(0.1, -1.0, 0.2)), 0.02}};
  bundle.state.world_from_body = {RigidTransform{}};
  return bundle;
}

TEST(Bundle, GradientsAreThoseOfTheCost) {
  const OrbitBundle bundle = bundle_with_rows();
  const BundleState state = shaken(bundle.state, bundle.problem, 0.01, 3);
  const NormalEquations equations = normal_equations(bundle.problem, state, 40.0, Progress{});
  EXPECT_NEAR(equations.cost, bundle_cost(bundle.problem, state, 40.0), 1e-9 * equations.cost);
  const auto cost_beside = [&](const Eigen::VectorXd& dense, int point, const Eigen::Vector3d& by) {
    std::vector<Eigen::Vector3d> points(state.points.size(), Eigen::Vector3d::Zero());
    if (point >= 0) points[std::size_t(point)] = by;
    return bundle_cost(bundle.problem, changed(state, equations.layout, dense, points), 40.0);
  };
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(equations.layout.dense_size);
  for (int i = 0; i < still.size(); ++i) {
    if (i >= equations.layout.kept_begin + 6 && i < equations.layout.kept_begin + 12)
      continue;  // a stick's ends: the change of its length is left out
    Eigen::VectorXd step = still;
    step[i] = 1e-6;
    const double slope = (cost_beside(step, -1, {}) - cost_beside(-step, -1, {})) / 2e-6;
    EXPECT_NEAR(slope, 2.0 * equations.gradient[i], 1e-3 * (1.0 + std::abs(slope))) << i;
  }
  const Eigen::Vector3d up(0.0, 0.0, 1e-6);
  const double slope = (cost_beside(still, 10, up) - cost_beside(still, 10, -up)) / 2e-6;
  EXPECT_NEAR(slope, 2.0 * equations.points[10].gradient.z(), 1e-3 * (1.0 + std::abs(slope)));
}

TEST(Bundle, NoSightingSeesAMoveOfTheWorld) {
  const OrbitBundle bundle = orbit_bundle(make_orbit({.photos = 5, .gross = 0.0}));
  const BundleLayout layout = layout_of(bundle.problem, bundle.state);
  const glm::dvec3 centre = mean_centre(bundle.state);
  const NormalEquations equations =
      normal_equations(bundle.problem, bundle.state, kLeastSquares, Progress{});
  const ReducedSystem system = reduced(equations, 0.0, Progress{});
  const Eigen::MatrixXd matrix = system.matrix.selfadjointView<Eigen::Lower>();
  for (int i = 0; i < 7; ++i) {
    GaugeMove move{};
    move[std::size_t(i)] = 1.0;
    const Eigen::VectorXd direction = gauge_direction(layout, bundle.state, move, centre);
    EXPECT_LT(direction.dot(matrix * direction),
              1e-6 * direction.squaredNorm() * matrix.diagonal().maxCoeff())
        << i;
  }
}

TEST(Bundle, FindsBackFromAShake) {
  OrbitBundle bundle = orbit_bundle(make_orbit({.photos = 8, .noise_px = 0.0, .gross = 0.0}));
  BundleState state = shaken(bundle.state, bundle.problem, 0.03, 5);
  EXPECT_LT(solve_bundle(bundle.problem, state, {kLeastSquares, 40}, Progress{}), 1e-6);
}

TEST(Bundle, GrossMistakesStopPulling) {
  OrbitBundle bundle = orbit_bundle(make_orbit({.seed = 2, .gross = 0.1}));
  const OrbitBundle exact = orbit_bundle(make_orbit({.seed = 2, .noise_px = 0.0, .gross = 0.0}));
  bundle.problem.coordinates.clear();
  BundleState state = exact.state, plain = exact.state;
  solve_bundle(bundle.problem, state, {5.0, 30}, Progress{});
  solve_bundle(bundle.problem, plain, {kLeastSquares, 30}, Progress{});
  const auto spread = [&](const BundleState& s) {
    double sum = 0.0;
    for (std::size_t i = 1; i < s.points.size(); ++i)
      sum += std::abs(glm::distance(s.points[i], s.points[0]) /
                          glm::distance(s.points[1], s.points[0]) -
                      glm::distance(exact.state.points[i], exact.state.points[0]) /
                          glm::distance(exact.state.points[1], exact.state.points[0]));
    return sum;
  };
  EXPECT_LT(5.0 * spread(state), spread(plain));
}

// Over many draws of noise the distances between markers spread as predicted. Forty draws of 21
// distances, which share cameras: the spread itself is known to about a tenth.
TEST(BundleCovariance, PredictsTheSpreadOfDistances) {
  constexpr int kDraws = 40;
  const OrbitBundle exact = orbit_bundle(
      make_orbit({.photos = 16, .markers = 7, .noise_px = 0.0, .gross = 0.0, .missing = 0.0}));
  BundleProblem problem = exact.problem;
  problem.lengths = {
      {0, 3, glm::distance(exact.state.points[0], exact.state.points[3]), 0.002, true}};
  problem.pinned = {{1, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 0},
                    {0, 0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1, 0}};
  const BundleCovariance covariance(problem, exact.state, 1.0, {}, Progress{});
  double predicted = 0.0, observed = 0.0;
  for (int a = 0; a < 7; ++a)
    for (int b = a + 1; b < 7; ++b) predicted += std::pow(covariance.distance_sigma(a, b), 2.0);
  for (int draw = 0; draw < kDraws; ++draw) {
    Random random(100 + std::uint64_t(draw));
    BundleProblem noisy = problem;
    for (BundleSighting& sighting : noisy.sightings)
      sighting.pixel += sighting.sigma_px * glm::dvec2(random.normal(), random.normal());
    noisy.lengths[0].length += noisy.lengths[0].sigma * random.normal();
    BundleState state = exact.state;
    solve_bundle(noisy, state, {kLeastSquares, 20}, Progress{});
    for (int a = 0; a < 7; ++a)
      for (int b = a + 1; b < 7; ++b)
        observed +=
            std::pow(glm::distance(state.points[std::size_t(a)], state.points[std::size_t(b)]) -
                         glm::distance(exact.state.points[std::size_t(a)],
                                       exact.state.points[std::size_t(b)]),
                     2.0) /
            kDraws;
  }
  EXPECT_NEAR(std::sqrt(predicted / observed), 1.0, 0.25);
}

}  // namespace
}  // namespace bosk
