#include "core/geometry/similarity.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "core/base/error.h"
#include "core/geometry/rotation.h"

namespace bosk {
namespace {

using glm::dvec3;

std::vector<dvec3> random_points(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-5.0, 5.0);
  std::vector<dvec3> points;
  points.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i)
    points.emplace_back(uniform(random), uniform(random), uniform(random));
  return points;
}

std::vector<dvec3> images(const Similarity& target_from_source, const std::vector<dvec3>& points) {
  std::vector<dvec3> result;
  result.reserve(points.size());
  for (const dvec3& point : points) result.push_back(target_from_source * point);
  return result;
}

const Similarity kTruth{0.37, rotation_from_rodrigues({0.4, -2.1, 1.3}), {100.0, -20.0, 3.0}};

TEST(FitSimilarity, RecoversScaleTurnAndShift) {
  const std::vector<dvec3> source = random_points(20, 1);
  const Similarity fit = fit_similarity(source, images(kTruth, source));
  EXPECT_NEAR(fit.scale, kTruth.scale, 1e-14);
  for (const dvec3& point : random_points(20, 2))
    EXPECT_LT(glm::length(fit * point - kTruth * point),
              1e-12);  // rounding at coordinates near 100
}

TEST(FitSimilarity, ThreePointsInAPlaneAreEnough) {
  const std::vector<dvec3> source{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const Similarity fit = fit_similarity(source, images(kTruth, source));
  EXPECT_LT(glm::length(fit * dvec3(0, 0, 1) - kTruth * dvec3(0, 0, 1)), 1e-12);
}

TEST(FitSimilarity, NeverMirrors) {
  const std::vector<dvec3> source = random_points(20, 3);
  std::vector<dvec3> mirrored = source;
  for (dvec3& point : mirrored) point.x = -point.x;
  EXPECT_NEAR(glm::determinant(fit_similarity(source, mirrored).rotation), 1.0, 1e-14);
}

TEST(FitSimilarity, MovingAwayFromTheFitIncreasesTheError) {
  const std::vector<dvec3> source = random_points(20, 4), noise = random_points(20, 5);
  std::vector<dvec3> target = images(kTruth, source);
  for (std::size_t i = 0; i < target.size(); ++i) target[i] += 0.1 * noise[i];
  const auto error = [&](const Similarity& s) {
    double sum = 0.0;
    for (std::size_t i = 0; i < target.size(); ++i) {
      const dvec3 miss = target[i] - s * source[i];
      sum += glm::dot(miss, miss);
    }
    return sum;
  };
  const Similarity fit = fit_similarity(source, target);
  for (const double step : {-1e-3, 1e-3}) {
    Similarity other = fit;
    other.scale += step;
    EXPECT_GT(error(other), error(fit));
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 change(0.0);
      change[axis] = step;
      other = fit;
      other.translation += change;
      EXPECT_GT(error(other), error(fit));
      other = fit;
      other.rotation = rotation_from_rodrigues(change) * fit.rotation;
      EXPECT_GT(error(other), error(fit));
    }
  }
}

TEST(FitSimilarity, RefusesWhatDoesNotFixIt) {
  const std::vector<dvec3> two{{0, 0, 0}, {1, 0, 0}};
  EXPECT_THROW(fit_similarity(two, two), Error);
  const std::vector<dvec3> line{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-3, -6, -9}};
  EXPECT_THROW(fit_similarity(line, line), Error);
  const std::vector<dvec3> same(5, dvec3(1.0));
  EXPECT_THROW(fit_similarity(same, same), Error);
  std::vector<dvec3> broken = random_points(5, 6);
  broken[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_similarity(broken, random_points(5, 7)), Error);
}

TEST(Similarity, InverseUndoesIt) {
  for (const dvec3& point : random_points(10, 8))
    EXPECT_LT(glm::length(inverse(kTruth) * (kTruth * point) - point), 1e-12);
}

TEST(Moved, CameraSeesMovedPointsInTheSameDirections) {
  const RigidTransform camera_from_source{rotation_from_rodrigues({0.1, 0.2, 0.3}), {1, 2, 3}};
  const RigidTransform camera_from_target = moved(camera_from_source, kTruth);
  for (const dvec3& point : random_points(10, 9)) {
    const dvec3 before = camera_from_source * point;
    const dvec3 after = camera_from_target * (kTruth * point);
    EXPECT_LT(glm::length(after - kTruth.scale * before), 1e-12);
  }
}

}  // namespace
}  // namespace bosk
