#include "core/matte/surroundings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/matte/blur.h"
#include "core/matte/distance_map.h"
#include "core/matte/grid.h"
#include "core/matte/scribbles.h"

namespace bosk {
namespace {

constexpr float kStrokeWeight = 4.0f;   // of a stroke's pixel against an estimated one
constexpr float kMostCertain = 0.005f;  // mean alpha is never believed to be nearer to 0 or 1
constexpr float kHardFrom = 0.4f, kHardTo = 0.8f;
constexpr float kCorrectionReach = 0.05f;  // diagonals
constexpr float kNearDistance =
    0.02f;  // diagonals; closer than this to a stroke makes no difference

struct WeighedAlpha {
  float alpha = 0.0f, weight = 1.0f;
};

WeighedAlpha weighed(float alpha, std::uint8_t stroke) {
  if (stroke == kForegroundStroke) return {1.0f, kStrokeWeight};
  if (stroke == kBackgroundStroke) return {0.0f, kStrokeWeight};
  // A constant half-tone is a background colour that no stroke shows: crowns are leaf by leaf clear
  // or opaque
  const float opaque = std::clamp((alpha - kHardFrom) / (kHardTo - kHardFrom), 0.0f, 1.0f);
  return {opaque, 1.0f};
}

float nearest(const std::vector<StrokeCluster>& clusters, std::size_t cell) {
  float least = 1e12f;
  for (const StrokeCluster& cluster : clusters) {
    least = std::min(least, cluster.squared_distance.data()[cell]);
  }
  return std::sqrt(least);
}

}  // namespace

Image<float> mean_alpha(const Image<float>& alpha, const Image<std::uint8_t>& strokes,
                        float sigma) {
  const int width = alpha.width(), height = alpha.height();
  const glm::ivec2 size = grid_size(width, height);
  Image<float> sum(size.x, size.y), weights(size.x, size.y);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int u = x * size.x / width, v = y * size.y / height;
      const WeighedAlpha item = weighed(alpha(x, y), strokes.empty() ? kNoStroke : strokes(x, y));
      sum(u, v) += item.weight * item.alpha;
      weights(u, v) += item.weight;
    }
  }
  const float sigma_cells = sigma * std::hypot(float(size.x), float(size.y));
  Image<float> mean = blurred(sum, sigma_cells);
  weights = blurred(weights, sigma_cells);
  for (std::size_t i = 0; i < mean.size(); ++i) mean.data()[i] /= weights.data()[i];
  return mean;
}

Image<float> region_tilt(const Image<float>& mean_alpha, float weight) {
  Image<float> tilt = mean_alpha;
  for (float& value : tilt.pixels()) {
    const float mean = std::clamp(value, kMostCertain, 1.0f - kMostCertain);
    value = weight * std::log(mean / (1.0f - mean));
  }
  return tilt;
}

Image<float> position_tilt(const StrokeModel& model, float weight) {
  Image<float> tilt = model.foreground.front().squared_distance;
  for (std::size_t i = 0; i < tilt.size(); ++i) {
    const float front = nearest(model.foreground, i), back = nearest(model.background, i);
    tilt.data()[i] = weight * (back - front) / (back + front + kNearDistance);
  }
  return tilt;
}

Image<float> correction_tilt(const Image<std::uint8_t>& strokes, float weight) {
  const glm::ivec2 size = grid_size(strokes.width(), strokes.height());
  const float diagonal = std::hypot(float(size.x), float(size.y));
  Image<float> tilt(size.x, size.y);
  for (const std::uint8_t kind : {kForegroundStroke, kBackgroundStroke}) {
    Image<std::uint8_t> marked(size.x, size.y);
    for (int y = 0; y < strokes.height(); ++y) {
      for (int x = 0; x < strokes.width(); ++x) {
        if (strokes(x, y) != kind) continue;
        marked(x * size.x / strokes.width(), y * size.y / strokes.height()) = 1;
      }
    }
    const Image<float> squared = squared_distance_to(marked);
    const float most = kind == kForegroundStroke ? weight : -weight;
    for (std::size_t i = 0; i < tilt.size(); ++i) {
      const float distance = std::sqrt(squared.data()[i]) / diagonal;
      tilt.data()[i] += most * kCorrectionReach / (kCorrectionReach + distance);
    }
  }
  return tilt;
}

Image<float> stretched(const Image<float>& grid, int width, int height) {
  if (grid.width() == width && grid.height() == height) return grid;
  Image<float> result(width, height);
  tbb::parallel_for(0, height, [&](int y) {
    const GridPlace row = grid_place(y, height, grid.height());
    for (int x = 0; x < width; ++x)
      result(x, y) = GridPoint{grid_place(x, width, grid.width()), row}.sample(grid);
  });
  return result;
}

Image<float> sum_of_grids(const Image<float>& a, const Image<float>& b) {
  Image<float> sum = stretched(b, a.width(), a.height());
  for (std::size_t i = 0; i < sum.size(); ++i) sum.data()[i] += a.data()[i];
  return sum;
}

}  // namespace bosk
