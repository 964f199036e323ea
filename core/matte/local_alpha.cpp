#include "core/matte/local_alpha.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/matte/blur.h"
#include "core/matte/grid.h"

namespace bosk {
namespace {

constexpr float kSurelyClear = 0.03f, kSurelyOpaque = 0.95f;
constexpr float kFrontReach = 0.01f, kBackReach = 0.0133f;  // fractions of the image diagonal
constexpr float kFewest = 1e-4f;                            // sure pixels per cell, after blurring
constexpr int kCell = 4;  // px; the means are kept on a grid this coarse

// Sums over the sure pixels of one kind: count, colour, squared length of the colour.
using Sums = std::array<Image<float>, 5>;

Sums sums_of(const Image<glm::vec3>& linear, const Image<float>& alpha, bool opaque,
             float sigma_px) {
  const int width = (alpha.width() + kCell - 1) / kCell,
            height = (alpha.height() + kCell - 1) / kCell;
  Sums sums;
  sums.fill(Image<float>(width, height, 0.0f));
  tbb::parallel_for(0, height, [&](int v) {
    for (int y = v * kCell; y < std::min((v + 1) * kCell, alpha.height()); ++y) {
      for (int x = 0; x < alpha.width(); ++x) {
        const float a = alpha(x, y);
        if (opaque ? a <= kSurelyOpaque : a >= kSurelyClear) continue;
        const glm::vec3& colour = linear(x, y);
        const std::array<float, 5> terms{1.0f, colour.x, colour.y, colour.z,
                                         glm::dot(colour, colour)};
        for (std::size_t k = 0; k < 5; ++k) sums[k](x / kCell, v) += terms[k];
      }
    }
  });
  for (Image<float>& plane : sums) plane = blurred(plane, sigma_px / kCell);
  return sums;
}

GridPlace cell_place(int pixel, int cells) {
  return place_in_cells((float(pixel) + 0.5f) / kCell - 0.5f, cells);
}

struct LocalColour {
  glm::vec3 mean{0.0f};
  float variance = 0.0f;  // all channels together
  float count = 0.0f;     // per cell
};

LocalColour colour_at(const Sums& sums, const GridPoint& point) {
  LocalColour local;
  local.count = point.sample(sums[0]);
  const float inverse = 1.0f / std::max(local.count, 1e-9f);
  local.mean =
      inverse * glm::vec3(point.sample(sums[1]), point.sample(sums[2]), point.sample(sums[3]));
  local.variance =
      std::max(inverse * point.sample(sums[4]) - glm::dot(local.mean, local.mean), 0.0f);
  return local;
}

float refined(const glm::vec3& colour, float alpha, const LocalColour& front,
              const LocalColour& back, float caution) {
  const glm::vec3 step = front.mean - back.mean;
  const float square = glm::dot(step, step);
  const float local = std::clamp(glm::dot(colour - back.mean, step) / (square + 1e-4f), 0.0f, 1.0f);
  const float trust = square / (square + caution * (front.variance + back.variance) + 1e-4f);
  return std::lerp(alpha, local, trust);
}

}  // namespace

void refine_locally(const Image<glm::vec3>& linear, float caution, Image<float>& alpha,
                    Progress& progress) {
  const float diagonal = std::hypot(float(alpha.width()), float(alpha.height()));
  const Sums front = sums_of(linear, alpha, true, kFrontReach * diagonal);
  progress.check();
  const Sums back = sums_of(linear, alpha, false, kBackReach * diagonal);
  tbb::parallel_for(0, alpha.height(), [&](int y) {
    const GridPlace row = cell_place(y, front[0].height());
    for (int x = 0; x < alpha.width(); ++x) {
      float& value = alpha(x, y);
      if (value < kSurelyClear || value > kSurelyOpaque) continue;
      const GridPoint point{cell_place(x, front[0].width()), row};
      const LocalColour f = colour_at(front, point), b = colour_at(back, point);
      if (std::min(f.count, b.count) > kFewest) value = refined(linear(x, y), value, f, b, caution);
    }
    progress.advance();
  });
}

}  // namespace bosk
