#include "core/radiance/fit.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/lanes.h"
#include "core/radiance/ray_kernel.h"

namespace bosk {
namespace {

constexpr float kMaxExtinction = 20.0f;
constexpr float kOpaque = 2e-3f;  // a ray ends when less light than this is left
constexpr float kMomentum = 0.9f, kVariance = 0.99f, kTiny = 1e-12f;  // Adam
constexpr float kFlat = 0.05f;  // differences below this are smoothed as squares
constexpr float kLastRate = 0.05f;

template <int N>
Nodes<N> nodes_of(const RadianceVolume& volume) {
  Nodes<N> nodes(volume.grid.size() + 1);
  for (std::size_t i = 0; i < volume.grid.size(); ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      const float* colour = &volume.colour[(i * N + j) * 3];
      nodes[i].rows[j] = Row{colour[0], colour[1], colour[2], j == 0 ? volume.extinction[i] : 0.0f};
    }
  }
  nodes.back() = {};
  return nodes;
}

template <int N>
void store(const Nodes<N>& nodes, RadianceVolume& volume) {
  for (std::size_t i = 0; i < volume.grid.size(); ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      for (int c = 0; c < 3; ++c)
        volume.colour[(i * N + j) * 3 + std::size_t(c)] = nodes[i].rows[j][c];
    }
    volume.extinction[i] = nodes[i].rows[0][3];
  }
}

// Numbers of the cells next to each cell towards +x, -x, +y, ...; absent ones name the cell itself.
using Neighbours = std::array<std::int32_t, 6>;

std::vector<Neighbours> neighbours_of(const SparseGrid& grid) {
  std::vector<Neighbours> result(grid.size());
  tbb::parallel_for(std::size_t(0), grid.size(), [&](std::size_t i) {
    for (int side = 0; side < 6; ++side) {
      glm::ivec3 at(grid.cells()[i]);
      at[side / 2] += side % 2 == 0 ? 1 : -1;
      const std::int32_t number = grid.find(at.x, at.y, at.z);
      result[i][std::size_t(side)] = number >= 0 ? number : std::int32_t(i);
    }
  });
  return result;
}

template <int N>
struct Adam {
  Nodes<N> nodes, mean, square;
  std::vector<Neighbours> neighbours;
  float smooth_colour = 0.0f, smooth_extinction = 0.0f;  // per step
  int steps = 0;

  Adam(Nodes<N> start, const SparseGrid& grid)
      : nodes(std::move(start)),
        mean(nodes.size()),
        square(nodes.size()),
        neighbours(neighbours_of(grid)) {}

  // Derivatives of the total variation sum |v_i - v_n| over neighbours, rounded off below kFlat.
  void add_variation(std::size_t i, Node<N>& gradient) const {
    for (const std::int32_t n : neighbours[i]) {
      const Node<N>& other = before[std::size_t(n)];
      for (int j = 0; j < N; ++j) {
        const Row difference = before[i].rows[j] - other.rows[j];
        for (int c = 0; c < 4; ++c) {
          const float weight = c < 3 ? smooth_colour : smooth_extinction;
          gradient.rows[j][c] +=
              weight * difference[c] / std::sqrt(difference[c] * difference[c] + kFlat * kFlat);
        }
      }
    }
  }
  Nodes<N> before;

  void step(std::array<FitLane<N>, kLanes>& lanes, const FitSchedule& schedule, float rate) {
    ++steps;
    const bool smooth = smooth_colour > 0.0f || smooth_extinction > 0.0f;
    if (smooth) before = nodes;
    const float unbias_mean = 1.0f / (1.0f - std::pow(kMomentum, float(steps)));
    const float unbias_square = 1.0f / (1.0f - std::pow(kVariance, float(steps)));
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size() - 1, 4096),
                      [&](const auto& range) {
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          Node<N> gradient{};
                          for (FitLane<N>& lane : lanes) {
                            for (int j = 0; j < N; ++j)
                              gradient.rows[j] += lane.gradient[i].rows[j];
                            lane.gradient[i] = {};
                          }
                          if (smooth) add_variation(i, gradient);
                          move(i, gradient, schedule, rate, unbias_mean, unbias_square);
                        }
                      });
    nodes.back() = {};
    for (FitLane<N>& lane : lanes) lane.gradient.back() = {};
  }

  void move(std::size_t i, const Node<N>& gradient, const FitSchedule& schedule, float rate,
            float unbias_mean, float unbias_square) {
    for (int j = 0; j < N; ++j) {
      Row& m = mean[i].rows[j];
      Row& s = square[i].rows[j];
      Row& value = nodes[i].rows[j];
      m = kMomentum * m + (1.0f - kMomentum) * gradient.rows[j];
      s = kVariance * s + (1.0f - kVariance) * gradient.rows[j] * gradient.rows[j];
      const float colour_rate = j == 0 ? schedule.colour_rate : schedule.harmonics_rate;
      for (int c = 0; c < 4; ++c) {
        const float direction = m[c] * unbias_mean / (std::sqrt(s[c] * unbias_square) + kTiny);
        const float size =
            c < 3 ? colour_rate : schedule.extinction_rate * std::clamp(value[c], 0.3f, 3.0f);
        value[c] -= rate * size * direction;
      }
      if (j > 0) value *= 1.0f - rate * schedule.harmonics_decay;
    }
    nodes[i].rows[0][3] = std::clamp(nodes[i].rows[0][3], 0.0f, kMaxExtinction);
  }
};

// Step size relative to the first, from 1 down to kLastRate along half a cosine: large steps find
// the tree, small ones settle the noise that the subsets leave.
float rate_of(double done) {
  return kLastRate + (1.0f - kLastRate) * 0.5f * float(1.0 + std::cos(std::numbers::pi * done));
}

template <int N>
void fit(RadianceVolume& volume, const RayCache& cache, const TrilinearSupport& support,
         const FitSchedule& schedule, Progress& progress,
         const std::function<bool(double)>& after_epoch) {
  Adam<N> adam(nodes_of<N>(volume), volume.grid);
  const double per_step = double(cache.rays.size()) / double(volume.grid.size()) / schedule.subsets;
  adam.smooth_colour = float(schedule.colour_variation * per_step);
  adam.smooth_extinction = float(schedule.extinction_variation * per_step);
  std::array<FitLane<N>, kLanes> lanes;
  for (FitLane<N>& lane : lanes) lane.gradient.resize(adam.nodes.size());
  const auto subsets = std::size_t(schedule.subsets);
  for (int epoch = 0; epoch < schedule.epochs; ++epoch) {
    progress.begin("Fitting colour and opacity", cache.tiles(), double(epoch) / schedule.epochs,
                   double(epoch + 1) / schedule.epochs);
    const std::vector<std::uint32_t> tiles = shuffled_tiles(cache, std::uint64_t(epoch));
    for (std::size_t subset = 0; subset < subsets; ++subset) {
      const std::size_t first = tiles.size() * subset / subsets;
      const std::size_t last = tiles.size() * (subset + 1) / subsets;
      for_each_lane(last - first, [&](std::size_t number, std::size_t begin, std::size_t end) {
        FitLane<N>& lane = lanes[number];
        for (std::size_t i = first + begin; i < first + end; ++i) {
          if (i % 64 == 0) progress.advance(64);
          fit_tile<N>(cache, cache.tile(tiles[i]), support, adam.nodes, lane);
        }
      });
      adam.step(lanes, schedule,
                rate_of((epoch + double(subset) / schedule.subsets) / schedule.epochs));
    }
    double squared = 0.0, count = 0.0;
    for (FitLane<N>& lane : lanes) {
      squared += lane.squared_error, count += double(lane.rays);
      lane.squared_error = 0.0, lane.rays = 0;
    }
    store<N>(adam.nodes, volume);
    const double mean = std::max(squared / (4.0 * std::max(count, 1.0)), 1e-12);
    if (after_epoch && !after_epoch(-10.0 * std::log10(mean))) return;
  }
}

}  // namespace

void fit_volume(RadianceVolume& volume, const RayCache& cache, const TrilinearSupport& support,
                const FitSchedule& schedule, Progress& progress,
                const std::function<bool(double)>& after_epoch) {
  switch (volume.degree) {
    case 0:
      return fit<1>(volume, cache, support, schedule, progress, after_epoch);
    case 1:
      return fit<4>(volume, cache, support, schedule, progress, after_epoch);
    default:
      return fit<9>(volume, cache, support, schedule, progress, after_epoch);
  }
}

void back_project_colour(RadianceVolume& volume, const RayCache& cache,
                         const TrilinearSupport& support, Progress& progress) {
  std::vector<float> extinction = volume.extinction;
  extinction.push_back(0.0f);
  std::array<std::vector<Row>, kLanes> sums;
  for (auto& lane : sums) lane.assign(extinction.size(), Row{});
  progress.begin("Projecting the photos' colours", cache.rays.size());
  for_each_lane(cache.rays.size(), [&](std::size_t number, std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      if (r % 1024 == 0) progress.advance(std::min<std::size_t>(1024, end - r));
      const CachedRay& ray = cache.rays[r];
      if (ray.target.a <= 0.02f) continue;  // its colour comes from too few light
      const glm::vec3 straight = glm::vec3(ray.target) / ray.target.a;
      float left = ray.target.a;
      for_each_sample(cache, ray, support, [&](std::int32_t s, const glm::vec3& fraction) {
        float weights[8];
        trilinear_weights(fraction, weights);
        const auto& corners = support.corners(s);
        float depth = 0.0f;
        for (int i = 0; i < 8; ++i)
          depth += weights[i] * extinction[std::size_t(corners.number[i])];
        const float kept = std::exp(-depth), share = left * (1.0f - kept);
        for (int i = 0; i < 8; ++i) {
          const auto corner = std::size_t(corners.number[i]);
          const float w = weights[i] * extinction[corner] / std::max(depth, kTiny) * share;
          sums[number][corner] += Row{straight.r, straight.g, straight.b, 1.0f} * w;
        }
        left *= kept;
        return left > kOpaque;
      });
    }
  });
  const std::size_t stride = std::size_t(volume.coefficients()) * 3;
  volume.colour.assign(volume.grid.size() * stride, 0.0f);
  tbb::parallel_for(std::size_t(0), volume.grid.size(), [&](std::size_t i) {
    Row sum{0.4f * 1e-6f, 0.4f * 1e-6f, 0.4f * 1e-6f, 1e-6f};  // unseen cells: grey
    for (const auto& lane : sums) sum += lane[i];
    for (int c = 0; c < 3; ++c) volume.colour[i * stride + std::size_t(c)] = sum[c] / sum[3];
  });
}

std::vector<float> cell_visibility(const RadianceVolume& volume, const RayCache& cache,
                                   const TrilinearSupport& support, Progress& progress) {
  std::vector<float> extinction = volume.extinction;
  extinction.push_back(0.0f);
  std::array<std::vector<float>, kLanes> largest;
  for (auto& lane : largest) lane.assign(extinction.size(), 0.0f);
  progress.begin("Finding what the photos can see", cache.rays.size());
  for_each_lane(cache.rays.size(), [&](std::size_t number, std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      if (r % 1024 == 0) progress.advance(std::min<std::size_t>(1024, end - r));
      float left = 1.0f;
      for_each_sample(cache, cache.rays[r], support,
                      [&](std::int32_t s, const glm::vec3& fraction) {
                        float weights[8];
                        trilinear_weights(fraction, weights);
                        const auto& corners = support.corners(s);
                        float depth = 0.0f;
                        for (int i = 0; i < 8; ++i) {
                          const auto cell = std::size_t(corners.number[i]);
                          const float own = weights[i] * extinction[cell];
                          depth += own;
                          largest[number][cell] =
                              std::max(largest[number][cell], left * (1.0f - std::exp(-own)));
                        }
                        left *= std::exp(-depth);
                        return left > kOpaque;
                      });
    }
  });
  std::vector<float> visibility(volume.grid.size(), 0.0f);
  for (std::size_t i = 0; i < visibility.size(); ++i) {
    for (const auto& lane : largest) visibility[i] = std::max(visibility[i], lane[i]);
  }
  return visibility;
}

}  // namespace bosk
