#include "core/matte/pair_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bosk {
namespace {

// Where the surroundings are clear, a pixel this much covered is doubted as much as an opaque one:
// a stem is opaque, not a half-covered bright leaf.
constexpr float kFullDoubt = 0.5f;

// Nearest point so far on a path, for each pixel of a run.
struct Nearest {
  float residual[kRun];  // squared distance in CIELab
  float alpha[kRun];
};

// The two helpers below are inlined into each clone of alpha_of_run, so that its loops are
// vectorised for the clone's processor.
[[gnu::always_inline]] inline void nearest_on_segment(const PixelRun& run, const glm::vec3& start,
                                                      const glm::vec3& step, float first_alpha,
                                                      float alpha_step, Nearest& nearest) {
  const float sx = start.x, sy = start.y, sz = start.z, dx = step.x, dy = step.y, dz = step.z;
  const float inverse = 1.0f / std::max(dx * dx + dy * dy + dz * dz, 1e-12f);
  const float *l = run.l, *a = run.a, *b = run.b;
  for (std::size_t i = 0; i < kRun; ++i) {
    const float x = l[i] - sx, y = a[i] - sy, z = b[i] - sz;
    float u = (x * dx + y * dy + z * dz) * inverse;
    u = u > 0.0f ? u : 0.0f;
    u = u < 1.0f ? u : 1.0f;
    const float rx = x - u * dx, ry = y - u * dy, rz = z - u * dz;
    const float residual = rx * rx + ry * ry + rz * rz;
    const bool nearer = residual < nearest.residual[i];
    nearest.alpha[i] = nearer ? first_alpha + u * alpha_step : nearest.alpha[i];
    nearest.residual[i] = nearer ? residual : nearest.residual[i];
  }
}

// Gaussian whose variance goes from the background's to the foreground's with alpha.
[[gnu::always_inline]] inline void weigh_path(const MixingPath& path, const PixelRun& run,
                                              const Nearest& nearest, float* __restrict exponent,
                                              float* __restrict greatest) {
  const float variance0 = path.background_variance;
  const float variance_step = path.foreground_variance - variance0;
  const float log0 = 1.5f * std::log(variance0);
  const float log_step = 1.5f * std::log(path.foreground_variance) - log0;
  const float* front = run.foreground_log_weight + std::size_t(path.foreground) * kRun;
  const float* back = run.background_log_weight + std::size_t(path.background) * kRun;
  const float* tilt = run.tilt;
  for (std::size_t i = 0; i < kRun; ++i) {
    const float alpha = nearest.alpha[i];
    exponent[i] = front[i] + back[i] - log0 -
                  0.5f * nearest.residual[i] / (variance0 + alpha * variance_step) +
                  std::min(tilt[i] < 0.0f ? alpha / kFullDoubt : alpha, 1.0f) * tilt[i] -
                  alpha * log_step;
    greatest[i] = exponent[i] > greatest[i] ? exponent[i] : greatest[i];
  }
}

[[gnu::always_inline]] inline void weigh_pure(const PureColour& pure, const PixelRun& run,
                                              float* __restrict exponent,
                                              float* __restrict greatest) {
  const float* weights = pure.opaque ? run.foreground_log_weight : run.background_log_weight;
  const float* weight = weights + std::size_t(pure.cluster) * kRun;
  const float *l = run.l, *a = run.a, *b = run.b, *tilt = run.tilt;
  const float alpha = pure.opaque ? 1.0f : 0.0f, log_weight = pure.log_weight;
  const float x0 = pure.lab.x, y0 = pure.lab.y, z0 = pure.lab.z;
  const auto [xx, yx, yy, zx, zy, zz] = pure.whitening;
  for (std::size_t i = 0; i < kRun; ++i) {
    const float x = l[i] - x0, y = a[i] - y0, z = b[i] - z0;
    const float u = xx * x, v = yx * x + yy * y, w = zx * x + zy * y + zz * z;
    exponent[i] = weight[i] + log_weight - 0.5f * (u * u + v * v + w * w) + alpha * tilt[i];
    greatest[i] = exponent[i] > greatest[i] ? exponent[i] : greatest[i];
  }
}

// e^x for x <= 0, to 2e-4 relative: 2^n from the exponent bits, 2^fraction from a polynomial.
[[gnu::always_inline]] inline float fast_exp(float x) {
  const float product = x * 1.44269504f;
  const float scaled = product > -126.0f ? product : -126.0f;
  const int whole = int(scaled) - 1;  // towards zero, less one: the fraction is in (0, 1]
  const float f = 0.5f * (scaled - float(whole));
  const float root =
      1.0f + f * (0.69314718f + f * (0.24022651f + f * (0.05550411f + f * 0.00961813f)));
  return root * root * std::bit_cast<float>((whole + 127) << 23);
}

struct Totals {
  float greatest[kRun];  // exponent
  float sum[kRun], weighted[kRun];
};

[[gnu::always_inline]] inline void add_path(const float* exponent, const float* alpha,
                                            Totals& totals) {
  for (std::size_t i = 0; i < kRun; ++i) {
    const float weight = fast_exp(exponent[i] - totals.greatest[i]);
    totals.sum[i] += weight;
    totals.weighted[i] += weight * alpha[i];
  }
}

}  // namespace

std::size_t scratch_size(const MixedColours& colours) {
  return (2 * colours.paths.size() + 2 * colours.pure.size()) * kRun;
}

// The widest clone that the processor knows is taken.
[[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]] void alpha_of_run(
    const MixedColours& colours, const PixelRun& run, float* scratch, const AlphaRun& result) {
  const std::size_t count = colours.paths.size() + colours.pure.size();
  float *exponent = scratch, *alpha = scratch + count * kRun;
  Totals totals{};
  std::fill_n(totals.greatest, kRun, -1e30f);
  Nearest nearest{};
  for (const MixingPath& path : colours.paths) {
    std::fill_n(nearest.residual, kRun, 1e30f);
    for (std::size_t k = 0; k < kMixingSegments; ++k) {
      const glm::vec3 start = path.corner[k];
      nearest_on_segment(run, start, path.corner[k + 1] - start, path.alpha[k],
                         path.alpha[k + 1] - path.alpha[k], nearest);
    }
    weigh_path(path, run, nearest, exponent, totals.greatest);
    std::copy_n(nearest.alpha, kRun, alpha);
    exponent += kRun;
    alpha += kRun;
  }
  for (const PureColour& pure : colours.pure) {
    weigh_pure(pure, run, exponent, totals.greatest);
    std::fill_n(alpha, kRun, pure.opaque ? 1.0f : 0.0f);
    exponent += kRun;
    alpha += kRun;
  }
  for (std::size_t i = 0; i < count; ++i) {
    add_path(scratch + i * kRun, scratch + (count + i) * kRun, totals);
  }
  for (std::size_t i = 0; i < kRun; ++i) {
    // Infinite or undefined input leaves a sum of 0, and then the pixel is clear
    const float sum = std::max(totals.sum[i], 1e-30f);
    result.alpha[i] = std::min(totals.weighted[i] / sum, 1.0f);
    result.likelihood[i] = std::clamp(totals.greatest[i] + std::log(sum), -1e30f, 1e30f);
  }
}

}  // namespace bosk
