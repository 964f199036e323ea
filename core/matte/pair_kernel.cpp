#include "core/matte/pair_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace bosk {
namespace {

// Constants of a path, laid out for the loop over pixels.
struct Segments {
  float x[kMixingSegments], y[kMixingSegments], z[kMixingSegments];     // start
  float dx[kMixingSegments], dy[kMixingSegments], dz[kMixingSegments];  // to the end
  float inverse_square[kMixingSegments];                                // 1 / length^2
};

Segments segments_of(const MixingPath& path) {
  Segments s{};
  for (std::size_t i = 0; i < kMixingSegments; ++i) {
    const glm::vec3 start = path.corner[i], step = path.corner[i + 1] - start;
    s.x[i] = start.x;
    s.y[i] = start.y;
    s.z[i] = start.z;
    s.dx[i] = step.x;
    s.dy[i] = step.y;
    s.dz[i] = step.z;
    s.inverse_square[i] = 1.0f / std::max(glm::dot(step, step), 1e-12f);
  }
  return s;
}

// e^x for x <= 0 to 2e-4 relative: 2^n from the exponent bits, 2^fraction from a cubic.
[[gnu::always_inline]] inline float fast_exp(float x) {
  const float scaled = std::max(x * 1.44269504f, -126.0f);
  const int whole =
      int(scaled) - 1;  // towards zero, less one: at most the floor, fraction in (0, 2)
  const float f = 0.5f * (scaled - float(whole));
  const float root =
      1.0f + f * (0.69314718f + f * (0.24022651f + f * (0.05550411f + f * 0.00961813f)));
  return root * root * std::bit_cast<float>((whole + 127) << 23);
}

}  // namespace

// The loops over the pixels of a run vectorise; the widest clone that the processor knows is taken.
[[gnu::target_clones("arch=skylake-avx512", "arch=haswell", "default")]] void alpha_of_run(
    const std::vector<MixingPath>& paths, const PixelRun& run, float* scratch,
    const AlphaRun& result) {
  float* exponent = scratch;
  float* share = scratch + paths.size() * kRun;
  float greatest[kRun];
  std::fill_n(greatest, kRun, -1e30f);
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const MixingPath& path = paths[p];
    const Segments s = segments_of(path);
    const float variance0 = path.background_variance;
    const float variance_step = path.foreground_variance - variance0;
    const float log0 = 1.5f * std::log(variance0);
    const float log_step = 1.5f * std::log(path.foreground_variance) - log0;
    const float* fw = run.foreground_log_weight + std::size_t(path.foreground) * kRun;
    const float* bw = run.background_log_weight + std::size_t(path.background) * kRun;
    float* e = exponent + p * kRun;
    float* t = share + p * kRun;
    for (std::size_t i = 0; i < kRun; ++i) {
      float best = 1e30f, best_alpha = 0.0f;
#pragma GCC unroll 6
      for (int k = 0; k < kMixingSegments; ++k) {
        const float x = run.l[i] - s.x[k], y = run.a[i] - s.y[k], z = run.b[i] - s.z[k];
        float u = (x * s.dx[k] + y * s.dy[k] + z * s.dz[k]) * s.inverse_square[k];
        u = std::min(std::max(u, 0.0f), 1.0f);
        const float rx = x - u * s.dx[k], ry = y - u * s.dy[k], rz = z - u * s.dz[k];
        const float residual = rx * rx + ry * ry + rz * rz;
        const float alpha = (float(k) + u) * (1.0f / kMixingSegments);
        best_alpha = residual < best ? alpha : best_alpha;
        best = residual < best ? residual : best;
      }
      const float variance = variance0 + best_alpha * variance_step;
      e[i] = -0.5f * best / variance - (log0 + best_alpha * log_step) + fw[i] + bw[i] +
             run.tilt[i] * best_alpha;
      t[i] = best_alpha;
      greatest[i] = std::max(greatest[i], e[i]);
    }
  }
  float sum[kRun] = {}, weighted[kRun] = {};
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const float* e = exponent + p * kRun;
    const float* t = share + p * kRun;
    for (std::size_t i = 0; i < kRun; ++i) {
      const float weight = fast_exp(e[i] - greatest[i]);
      sum[i] += weight;
      weighted[i] += weight * t[i];
    }
  }
  for (std::size_t i = 0; i < kRun; ++i) {
    result.alpha[i] = weighted[i] / sum[i];
    result.likelihood[i] = greatest[i] + std::log(sum[i]);
  }
}

}  // namespace bosk
