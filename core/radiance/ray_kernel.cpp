#include "core/radiance/ray_kernel.h"

#include <array>
#include <cmath>

#include "core/radiance/harmonics.h"

namespace bosk {
namespace {

constexpr float kOpaque = 2e-3f;  // a ray ends when less light than this is left
constexpr float kTiny = 1e-12f;

// Two corners side by side. Everything below is inlined into each clone of fit_tile, so that it is
// compiled for the clone's processor.
using Pair = float __attribute__((vector_size(32)));

[[gnu::always_inline]] inline Pair both(const Row& a, const Row& b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

[[gnu::always_inline]] inline Pair halves(float a, float b) { return Pair{a, a, a, a, b, b, b, b}; }

// Lane 3 of each half in all of that half's lanes.
[[gnu::always_inline]] inline Pair last_lanes(const Pair& v) {
  return __builtin_shufflevector(v, v, 3, 3, 3, 3, 7, 7, 7, 7);
}

// The sum of each half in all of its lanes.
[[gnu::always_inline]] inline Pair half_sums(const Pair& v) {
  const Pair pairs = v + __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6);
  return pairs + __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1, 6, 7, 4, 5);
}

[[gnu::always_inline]] inline Row sum_of_halves(const Pair& v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
}

[[gnu::always_inline]] inline float dot3(const Row& a, const Row& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Composite {
  Row colour{};       // premultiplied, lane 3 unused
  float left = 1.0f;  // light left behind the last sample
};

template <int N>
[[gnu::always_inline]] inline Pair view_colours(const Node<N>& a, const Node<N>& b,
                                                const std::array<float, kMaxCoefficients>& basis) {
  Pair colour = both(a.rows[0], b.rows[0]);
  for (int j = 1; j < N; ++j) colour += both(a.rows[j], b.rows[j]) * basis[std::size_t(j)];
  return colour;
}

// The trilinear extinction, and the mean of the corners' colours weighted by their shares in it.
template <int N>
[[gnu::always_inline]] inline void interpolate(const TrilinearSupport::Corners& corners,
                                               const Nodes<N>& nodes,
                                               const std::array<float, kMaxCoefficients>& basis,
                                               Sample& sample) {
  Pair colour{}, extinction{};
  for (int i = 0; i < 8; i += 2) {
    const Node<N>& a = nodes[std::size_t(corners.number[i])];
    const Node<N>& b = nodes[std::size_t(corners.number[i + 1])];
    const Pair own = both(a.rows[0], b.rows[0]);
    const Pair part = halves(sample.weights[i], sample.weights[i + 1]) * last_lanes(own);
    extinction += part;
    colour += part * view_colours<N>(a, b, basis);
  }
  sample.extinction = sum_of_halves(extinction)[0] + kTiny;
  sample.colour = sum_of_halves(colour) / sample.extinction;
  sample.colour[3] = 0.0f;
}

template <int N>
[[gnu::always_inline]] inline Composite march(const RayCache& cache, const CachedRay& ray,
                                              const TrilinearSupport& support,
                                              const Nodes<N>& nodes,
                                              const std::array<float, kMaxCoefficients>& basis,
                                              std::vector<Sample>& samples, std::size_t& count) {
  Composite sum;
  count = 0;
  for_each_sample(
      cache, ray,
      support, [&](std::int32_t number, const glm::vec3& fraction) __attribute__((always_inline)) {
        Sample& sample = samples[count++];
        sample.support = number;
        trilinear_weights(fraction, sample.weights);
        interpolate<N>(support.corners(number), nodes, basis, sample);
        sample.kept = std::exp(-sample.extinction);
        sample.before = sum.left;
        sum.colour += sample.colour * (sum.left * (1.0f - sample.kept));
        sum.left *= sample.kept;
        return sum.left > kOpaque;
      });
  return sum;
}

// Adds the loss's derivatives by the values at the sample's corners to `gradient`.
template <int N>
[[gnu::always_inline]] inline void scatter(const Sample& sample,
                                           const TrilinearSupport::Corners& corners,
                                           const Row& by_colour, float by_depth,
                                           const Nodes<N>& nodes,
                                           const std::array<float, kMaxCoefficients>& basis,
                                           Nodes<N>& gradient) {
  const Pair by_colours = both(by_colour, by_colour);
  const float at_sample = by_depth - dot3(by_colour, sample.colour);
  for (int i = 0; i < 8; i += 2) {
    const auto a = std::size_t(corners.number[i]), b = std::size_t(corners.number[i + 1]);
    const Pair own = both(nodes[a].rows[0], nodes[b].rows[0]);
    const Pair weights = halves(sample.weights[i], sample.weights[i + 1]);
    const Pair colours = by_colours * (weights * last_lanes(own));
    const Pair depth =
        weights * (at_sample + half_sums(by_colours * view_colours<N>(nodes[a], nodes[b], basis)));
    const Pair change = __builtin_shufflevector(colours, depth, 0, 1, 2, 11, 4, 5, 6, 15);
    gradient[a].rows[0] += __builtin_shufflevector(change, change, 0, 1, 2, 3);
    gradient[b].rows[0] += __builtin_shufflevector(change, change, 4, 5, 6, 7);
    for (int j = 1; j < N; ++j) {
      const Pair higher = colours * basis[std::size_t(j)];
      gradient[a].rows[j] += __builtin_shufflevector(higher, higher, 0, 1, 2, 3);
      gradient[b].rows[j] += __builtin_shufflevector(higher, higher, 4, 5, 6, 7);
    }
  }
}

template <int N>
[[gnu::always_inline]] inline void fit_ray(const RayCache& cache, const CachedRay& ray,
                                           const TrilinearSupport& support, const Nodes<N>& nodes,
                                           FitLane<N>& lane) {
  const auto basis = harmonics(ray.direction);
  std::size_t count = 0;
  const Composite sum = march<N>(cache, ray, support, nodes, basis, lane.samples, count);
  Row error = sum.colour - Row{ray.target.r, ray.target.g, ray.target.b, 0.0f};
  error[3] = 1.0f - sum.left - ray.target.a;
  for (int c = 0; c < 4; ++c) lane.squared_error += double(error[c]) * double(error[c]);
  ++lane.rays;

  Row colour_error = error, behind{};  // behind: colour that the samples further back add
  colour_error[3] = 0.0f;
  for (std::size_t k = count; k-- > 0;) {
    const Sample& sample = lane.samples[k];
    const float share = sample.before * (1.0f - sample.kept);
    const Row ahead = sample.colour * (sample.before * sample.kept) - behind;
    scatter<N>(sample, support.corners(sample.support), colour_error * (share / sample.extinction),
               dot3(colour_error, ahead) + error[3] * sum.left, nodes, basis, lane.gradient);
    behind += sample.colour * share;
  }
}

template <int N>
[[gnu::always_inline]] inline void fit_rays(const RayCache& cache, std::span<const CachedRay> tile,
                                            const TrilinearSupport& support, const Nodes<N>& nodes,
                                            FitLane<N>& lane) {
  for (const CachedRay& ray : tile) {
    std::size_t most = 0;
    for (std::uint32_t i = 0; i < ray.span_count; ++i) {
      const SampleSpan& span = cache.spans[ray.first_span + i];
      most += std::size_t(span.last - span.first);
    }
    if (lane.samples.size() < most) lane.samples.resize(most);
    fit_ray<N>(cache, ray, support, nodes, lane);
  }
}

}  // namespace

template <>
[[gnu::target_clones("arch=x86-64-v3", "default")]] void fit_tile<1>(
    const RayCache& cache, std::span<const CachedRay> tile, const TrilinearSupport& support,
    const Nodes<1>& nodes, FitLane<1>& lane) {
  fit_rays<1>(cache, tile, support, nodes, lane);
}

template <>
[[gnu::target_clones("arch=x86-64-v3", "default")]] void fit_tile<4>(
    const RayCache& cache, std::span<const CachedRay> tile, const TrilinearSupport& support,
    const Nodes<4>& nodes, FitLane<4>& lane) {
  fit_rays<4>(cache, tile, support, nodes, lane);
}

template <>
[[gnu::target_clones("arch=x86-64-v3", "default")]] void fit_tile<9>(
    const RayCache& cache, std::span<const CachedRay> tile, const TrilinearSupport& support,
    const Nodes<9>& nodes, FitLane<9>& lane) {
  fit_rays<9>(cache, tile, support, nodes, lane);
}

}  // namespace bosk
