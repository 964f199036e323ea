#include "core/matte/distance_map.h"

#include <cmath>
#include <vector>

namespace bosk {
namespace {

constexpr float kFar = 1e12f;

// Distance to the nearest mark in the pixel's own column.
Image<float> distance_in_column(const Image<std::uint8_t>& marked) {
  Image<float> distance(marked.width(), marked.height());
  for (int x = 0; x < marked.width(); ++x) {
    float nearest = std::sqrt(kFar);
    for (int y = 0; y < marked.height(); ++y) {
      nearest = marked(x, y) ? 0.0f : nearest + 1.0f;
      distance(x, y) = nearest;
    }
    for (int y = marked.height() - 1; y >= 0; --y) {
      nearest = marked(x, y) ? 0.0f : std::min(nearest, distance(x, y)) + 1.0f;
      distance(x, y) = std::min(distance(x, y), nearest);
    }
  }
  return distance;
}

// Lower envelope of the parabolas (x - centre)^2 + height[centre], evaluated at every x.
class Envelope {
 public:
  explicit Envelope(std::size_t width) : centre_(width), from_(width) {}

  void rebuild(const float* height, int width) {
    last_ = -1;
    for (int x = 0; x < width; ++x) {
      double start = -1e30;
      while (last_ >= 0) {
        start = crossing(height, centre_[std::size_t(last_)], x);
        if (start > from_[std::size_t(last_)]) break;
        --last_;
      }
      ++last_;
      centre_[std::size_t(last_)] = x;
      from_[std::size_t(last_)] = last_ == 0 ? -1e30 : start;
    }
  }

  void evaluate(const float* height, int width, float* value) const {
    std::size_t piece = 0;
    for (int x = 0; x < width; ++x) {
      while (int(piece) < last_ && from_[piece + 1] <= x) ++piece;
      const float offset = float(x - centre_[piece]);
      value[x] = std::min(offset * offset + height[centre_[piece]], kFar);
    }
  }

 private:
  static double crossing(const float* height, int a, int b) {
    const double at_a = double(height[a]) + double(a) * a, at_b = double(height[b]) + double(b) * b;
    return (at_b - at_a) / (2.0 * (b - a));
  }

  std::vector<int> centre_;
  std::vector<double> from_;
  int last_ = -1;
};

}  // namespace

Image<float> squared_distance_to(const Image<std::uint8_t>& marked) {
  Image<float> squared = distance_in_column(marked);
  for (float& value : squared.pixels()) value = std::min(value * value, kFar);
  Envelope envelope(std::size_t(marked.width()));
  std::vector<float> heights(std::size_t(marked.width()));
  for (int y = 0; y < marked.height(); ++y) {
    float* row = squared.data() + std::size_t(y) * std::size_t(marked.width());
    heights.assign(row, row + marked.width());
    envelope.rebuild(heights.data(), marked.width());
    envelope.evaluate(heights.data(), marked.width(), row);
  }
  return squared;
}

}  // namespace bosk
