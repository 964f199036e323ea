#include "core/matte/mixing.h"

#include "core/image/colour.h"

namespace bosk {
namespace {

glm::vec3 mixed_lab(const glm::vec3& background, const glm::vec3& foreground, float alpha,
                    const std::string& mixing) {
  if (mixing == "lab") return glm::mix(background, foreground, alpha);
  if (mixing == "srgb") {
    return lab_from_srgb(glm::mix(srgb_from_lab(background), srgb_from_lab(foreground), alpha));
  }
  return lab_from_linear(glm::mix(linear_from_lab(background), linear_from_lab(foreground), alpha));
}

}  // namespace

std::vector<MixingPath> mixing_paths(const StrokeModel& model, const std::string& mixing) {
  std::vector<MixingPath> paths;
  for (std::size_t f = 0; f < model.foreground.size(); ++f) {
    for (std::size_t b = 0; b < model.background.size(); ++b) {
      const ColourCluster &front = model.foreground[f].colour, &back = model.background[b].colour;
      MixingPath path;
      for (int i = 0; i <= kMixingSegments; ++i) {
        path.corner[std::size_t(i)] =
            mixed_lab(back.lab, front.lab, float(i) / kMixingSegments, mixing);
      }
      path.background_variance = back.variance;
      path.foreground_variance = front.variance;
      path.foreground = int(f);
      path.background = int(b);
      paths.push_back(path);
    }
  }
  return paths;
}

}  // namespace bosk
