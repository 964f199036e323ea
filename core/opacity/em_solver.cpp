#include "core/opacity/em_solver.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/lanes.h"

namespace bosk {
namespace {

constexpr float kMaxExtinction = 20.0f;
constexpr float kMaxShrink = 0.05f, kMaxGrowth = 4.0f;  // of one update

struct Sums {
  float rise = 0.0f, fall = 0.0f, weight = 0.0f;
};

struct Lane {
  std::vector<Sums> sums;
  double error = 0.0;
  std::size_t rays = 0;
};

void scatter_ray(const RayCache& cache, const CachedRay& ray, const TrilinearSupport& support,
                 const std::vector<float>& extinction, Lane& lane) {
  float depth = 0.0f;
  for_each_sample(cache, ray, support, [&](std::int32_t number, const glm::vec3& fraction) {
    float weights[8];
    trilinear_weights(fraction, weights);
    const auto& corners = support.corners(number);
    for (int i = 0; i < 8; ++i) depth += weights[i] * extinction[std::size_t(corners.number[i])];
    return true;
  });
  const float kept = std::exp(-depth);
  const float rise = ray.target.a * kept, fall = (1.0f - kept) * kept;
  for_each_sample(cache, ray, support, [&](std::int32_t number, const glm::vec3& fraction) {
    float weights[8];
    trilinear_weights(fraction, weights);
    const auto& corners = support.corners(number);
    for (int i = 0; i < 8; ++i) {
      Sums& sums = lane.sums[std::size_t(corners.number[i])];
      sums.rise += weights[i] * rise;
      sums.fall += weights[i] * fall;
      sums.weight += weights[i];
    }
    return true;
  });
  lane.error += std::abs(double(1.0f - kept) - double(ray.target.a));
  ++lane.rays;
}

void update(std::array<Lane, kLanes>& lanes, std::vector<float>& extinction) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, extinction.size(), 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          Sums sums;
          for (Lane& lane : lanes) {
            sums.rise += lane.sums[i].rise;
            sums.fall += lane.sums[i].fall;
            sums.weight += lane.sums[i].weight;
            lane.sums[i] = {};
          }
          if (sums.weight == 0.0f) continue;
          const float ratio = sums.rise / (sums.fall + 1e-6f * sums.weight);
          extinction[i] =
              std::min(kMaxExtinction, extinction[i] * std::clamp(ratio, kMaxShrink, kMaxGrowth));
        }
      });
}

}  // namespace

double em_pass(const RayCache& cache, const TrilinearSupport& support, int subsets,
               std::vector<float>& extinction, Progress& progress) {
  const std::size_t cells = extinction.size();
  extinction.push_back(0.0f);  // absent corners
  std::array<Lane, kLanes> lanes;
  for (Lane& lane : lanes) lane.sums.resize(cells + 1);
  const std::vector<std::uint32_t> tiles = shuffled_tiles(cache, 0);
  for (int subset = 0; subset < subsets; ++subset) {
    const std::size_t first = tiles.size() * std::size_t(subset) / std::size_t(subsets);
    const std::size_t last = tiles.size() * std::size_t(subset + 1) / std::size_t(subsets);
    for_each_lane(last - first, [&](std::size_t lane, std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i) {
        for (const CachedRay& ray : cache.tile(tiles[i])) {
          scatter_ray(cache, ray, support, extinction, lanes[lane]);
        }
        if (i % 64 == 0) progress.advance(64);
      }
    });
    update(lanes, extinction);
    extinction[cells] = 0.0f;
  }
  extinction.pop_back();
  double error = 0.0;
  std::size_t rays = 0;
  for (const Lane& lane : lanes) error += lane.error, rays += lane.rays;
  return rays == 0 ? 0.0 : error / double(rays);
}

}  // namespace bosk
