#include "core/matte/mixing.h"

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr std::size_t kFineSteps = 48;  // that measure a mixing curve's length
constexpr float kLeastSpread = 0.03f;   // Lab units; below, rounding rules

glm::vec3 mixed_lab(const glm::vec3& background, const glm::vec3& foreground, float alpha,
                    const std::string& mixing) {
  if (mixing == "lab") return glm::mix(background, foreground, alpha);
  if (mixing == "srgb") {
    return lab_from_srgb(glm::mix(srgb_from_lab(background), srgb_from_lab(foreground), alpha));
  }
  return lab_from_linear(glm::mix(linear_from_lab(background), linear_from_lab(foreground), alpha));
}

// Alphas that divide the curve into pieces of equal length: light mixed evenly runs through the
// dark end of CIELab fastest.
std::array<float, kMixingSegments + 1> even_alphas(const glm::vec3& background,
                                                   const glm::vec3& foreground,
                                                   const std::string& mixing) {
  std::array<float, kFineSteps + 1> length{};
  glm::vec3 last = background;
  for (std::size_t i = 1; i <= kFineSteps; ++i) {
    const glm::vec3 next = mixed_lab(background, foreground, float(i) / kFineSteps, mixing);
    length[i] = length[i - 1] + glm::distance(last, next);
    last = next;
  }
  std::array<float, kMixingSegments + 1> alphas{};
  std::size_t step = 0;
  for (std::size_t k = 1; k < kMixingSegments; ++k) {
    const float wanted = length.back() * float(k) / kMixingSegments;
    while (step + 1 < kFineSteps && length[step + 1] < wanted) ++step;
    const float piece = std::max(length[step + 1] - length[step], 1e-12f);
    const float within = std::clamp((wanted - length[step]) / piece, 0.0f, 1.0f);
    alphas[k] = (float(step) + within) / kFineSteps;
  }
  alphas.back() = 1.0f;
  return alphas;
}

MixingPath path_between(const ColourCluster& back, const ColourCluster& front,
                        const std::string& mixing) {
  MixingPath path;
  path.alpha = even_alphas(back.lab, front.lab, mixing);
  for (std::size_t i = 0; i <= kMixingSegments; ++i) {
    path.corner[i] = mixed_lab(back.lab, front.lab, path.alpha[i], mixing);
  }
  path.background_variance = back.variance;
  path.foreground_variance = front.variance;
  return path;
}

// Inverts the Cholesky factor of the covariance.
PureColour pure_colour(const ColourCluster& colour, float purity) {
  const auto& [xx, yx, yy, zx, zy, zz] = colour.covariance;
  const float a = std::sqrt(xx), b = yx / a, d = zx / a;
  const float c = std::sqrt(std::max(yy - b * b, kLeastSpread * kLeastSpread));
  const float e = (zy - d * b) / c;
  const float f = std::sqrt(std::max(zz - d * d - e * e, kLeastSpread * kLeastSpread));
  PureColour pure;
  pure.lab = colour.lab;
  pure.whitening = {1.0f / a,     -b / (a * c), 1.0f / c, (b * e - d * c) / (a * c * f),
                    -e / (c * f), 1.0f / f};
  pure.log_weight = purity - std::log(a * c * f);
  return pure;
}

}  // namespace

std::vector<MixingPath> mixing_paths(const StrokeModel& model, const std::string& mixing) {
  std::vector<MixingPath> paths;
  for (std::size_t f = 0; f < model.foreground.size(); ++f) {
    for (std::size_t b = 0; b < model.background.size(); ++b) {
      paths.push_back(path_between(model.background[b].colour, model.foreground[f].colour, mixing));
      paths.back().foreground = int(f);
      paths.back().background = int(b);
    }
  }
  return paths;
}

std::vector<PureColour> pure_colours(const StrokeModel& model, float purity) {
  std::vector<PureColour> all;
  const auto add = [&](const std::vector<StrokeCluster>& clusters, bool opaque) {
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      all.push_back(pure_colour(clusters[c].colour, purity));
      all.back().opaque = opaque;
      all.back().cluster = int(c);
    }
  };
  add(model.background, false);
  add(model.foreground, true);
  return all;
}

}  // namespace bosk
