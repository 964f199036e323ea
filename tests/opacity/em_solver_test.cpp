#include "core/opacity/em_solver.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bosk {
namespace {

constexpr int kCells = 8;  // along the ray

// One ray along the centres of a row of cells: each sample weighs one cell alone.
struct RowOfCells {
  SparseGrid grid;
  TrilinearSupport support;
  RayCache cache;

  explicit RowOfCells(float alpha)
      : grid(3, {{0, 4, 4},
                 {1, 4, 4},
                 {2, 4, 4},
                 {3, 4, 4},
                 {4, 4, 4},
                 {5, 4, 4},
                 {6, 4, 4},
                 {7, 4, 4}}),
        support(grid) {
    CachedRay ray;
    ray.direction = {1.0f, 0.0f, 0.0f};
    ray.first_sample = 1.0f;
    ray.span_count = 1;
    ray.target = glm::vec4(alpha);
    cache.rays = {ray};
    cache.spans = {{0, kCells}};
    cache.origins = {{-1.0f, 4.0f, 4.0f}};
    cache.first_rays = {0, 1};
  }
};

double pass(const RowOfCells& row, std::vector<float>& extinction) {
  Progress progress;
  return em_pass(row.cache, row.support, 1, extinction, progress);
}

float alpha_of(const std::vector<float>& extinction) {
  float depth = 0.0f;
  for (const float value : extinction) depth += value;
  return 1.0f - std::exp(-depth);
}

TEST(EmPass, ReachesTheMatteAlongOneRay) {
  for (const float alpha : {0.3f, 0.6f, 0.9f}) {
    const RowOfCells row(alpha);
    std::vector<float> extinction(kCells, 0.15f);
    for (int i = 0; i < 60; ++i) pass(row, extinction);
    EXPECT_NEAR(alpha_of(extinction), alpha, 1e-3f);  // the update's own 1e-6 guard and rounding
    for (const float value : extinction) EXPECT_NEAR(value, extinction[0], 1e-5f);
  }
}

TEST(EmPass, FollowsTheUpdateFormula) {
  const float start = 0.15f, alpha = 0.5f;
  const RowOfCells row(alpha);
  std::vector<float> extinction(kCells, start);
  const float kept = std::exp(-start * kCells);
  EXPECT_NEAR(pass(row, extinction), 1.0f - kept - alpha, 1e-5);
  const float expected = start * alpha / (1.0f - kept);
  for (const float value : extinction) EXPECT_NEAR(value, expected, 1e-5f);
}

TEST(EmPass, LowersTheErrorOverPasses) {
  const RowOfCells row(0.8f);
  std::vector<float> extinction(kCells, 0.02f);
  double last = pass(row, extinction);
  for (int i = 0; i < 4; ++i) {
    const double error = pass(row, extinction);
    EXPECT_LT(error, last);
    last = error;
  }
}

TEST(EmPass, DrivesCellsOnClearRaysToNothing) {
  const RowOfCells row(0.0f);
  std::vector<float> extinction(kCells, 0.15f);
  for (int i = 0; i < 4; ++i) pass(row, extinction);
  for (const float value : extinction) EXPECT_LT(value, 1e-5f);  // 0.15 * 0.05^4 = 1e-6
}

TEST(EmPass, LeavesCellsThatNoRayMeets) {
  RowOfCells row(0.0f);
  row.cache.spans[0].last = 4;
  std::vector<float> extinction(kCells, 0.15f);
  pass(row, extinction);
  EXPECT_LT(extinction[3], 0.15f);
  EXPECT_EQ(extinction[4], 0.15f);
}

}  // namespace
}  // namespace bosk
