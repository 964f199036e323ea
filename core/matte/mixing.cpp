#include "core/matte/mixing.h"

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"

namespace bosk {
namespace {

constexpr float kLeastSpread = 0.03f;  // Lab units; below, rounding rules

glm::vec3 mixed_lab(const glm::vec3& background, const glm::vec3& foreground, float alpha,
                    const std::string& mixing) {
  if (mixing == "lab") return glm::mix(background, foreground, alpha);
  if (mixing == "srgb") {
    return lab_from_srgb(glm::mix(srgb_from_lab(background), srgb_from_lab(foreground), alpha));
  }
  return lab_from_linear(glm::mix(linear_from_lab(background), linear_from_lab(foreground), alpha));
}

MixingPath path_between(const ColourCluster& back, const ColourCluster& front,
                        const std::string& mixing) {
  MixingPath path;
  for (int i = 0; i <= kMixingSegments; ++i) {
    path.corner[std::size_t(i)] =
        mixed_lab(back.lab, front.lab, float(i) / kMixingSegments, mixing);
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
