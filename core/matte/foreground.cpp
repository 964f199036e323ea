#include "core/matte/foreground.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace bosk {
namespace {

constexpr float kRegularization = 1e-5f;  // pull between neighbours where alpha is flat
constexpr float kGradientWeight = 0.1f;   // the same per unit of alpha step
constexpr int kRoundsWhenSmall = 10, kRoundsWhenLarge = 3;
constexpr int kSmall = 32;

// One level of the pyramid: light and alpha.
struct Level {
  Image<glm::vec3> linear;
  Image<float> alpha;
};

struct Layers {
  Image<glm::vec3> front, back;
};

template <class T>
Image<T> half(const Image<T>& full) {
  Image<T> small((full.width() + 1) / 2, (full.height() + 1) / 2);
  tbb::parallel_for(0, small.height(), [&](int y) {
    const int y0 = 2 * y, y1 = std::min(y0 + 1, full.height() - 1);
    for (int x = 0; x < small.width(); ++x) {
      const int x0 = 2 * x, x1 = std::min(x0 + 1, full.width() - 1);
      small(x, y) = 0.25f * (full(x0, y0) + full(x1, y0) + full(x0, y1) + full(x1, y1));
    }
  });
  return small;
}

std::vector<Level> pyramid(const Image<glm::vec3>& linear, const Image<float>& alpha) {
  std::vector<Level> levels{{linear, alpha}};
  while (std::max(levels.back().alpha.width(), levels.back().alpha.height()) > 1) {
    levels.push_back({half(levels.back().linear), half(levels.back().alpha)});
  }
  return levels;
}

// Both layers at one pixel that best mix to its colour and least differ from the neighbours'
// layers: two normal equations, the same for each channel.
void solve_pixel(const Level& level, const Layers& old, int x, int y, Layers& next) {
  const float alpha = level.alpha(x, y), rest = 1.0f - alpha;
  float pull = 0.0f;
  glm::vec3 front(0.0f), back(0.0f);
  const auto neighbour = [&](int nx, int ny) {
    nx = std::clamp(nx, 0, level.alpha.width() - 1);
    ny = std::clamp(ny, 0, level.alpha.height() - 1);
    const float weight = kRegularization + kGradientWeight * std::abs(alpha - level.alpha(nx, ny));
    pull += weight;
    front += weight * old.front(nx, ny);
    back += weight * old.back(nx, ny);
  };
  neighbour(x - 1, y);
  neighbour(x + 1, y);
  neighbour(x, y - 1);
  neighbour(x, y + 1);
  const glm::vec3 right_front = alpha * level.linear(x, y) + front;
  const glm::vec3 right_back = rest * level.linear(x, y) + back;
  const float aa = alpha * alpha + pull, ab = alpha * rest, bb = rest * rest + pull;
  const float inverse = 1.0f / (aa * bb - ab * ab);
  const glm::vec3 low(0.0f), high(1.0f);
  next.front(x, y) = glm::clamp(inverse * (bb * right_front - ab * right_back), low, high);
  next.back(x, y) = glm::clamp(inverse * (aa * right_back - ab * right_front), low, high);
}

Image<glm::vec3> enlarged(const Image<glm::vec3>& small, int width, int height) {
  Image<glm::vec3> large(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) large(x, y) = small(x / 2, y / 2);
  }
  return large;
}

void refine(const Level& level, Layers& layers, Progress& progress) {
  const int width = level.alpha.width(), height = level.alpha.height();
  const int rounds = std::max(width, height) <= kSmall ? kRoundsWhenSmall : kRoundsWhenLarge;
  Layers next{{width, height}, {width, height}};
  for (int round = 0; round < rounds; ++round) {
    tbb::parallel_for(0, height, [&](int y) {
      progress.check();
      for (int x = 0; x < width; ++x) solve_pixel(level, layers, x, y, next);
    });
    std::swap(layers, next);
  }
}

glm::vec3 mean_colour(const Level& level, bool front) {
  glm::dvec3 sum(0.0);
  double weights = 1e-6;
  for (std::size_t i = 0; i < level.alpha.size(); ++i) {
    const double weight = front ? level.alpha.data()[i] : 1.0f - level.alpha.data()[i];
    sum += weight * glm::dvec3(level.linear.data()[i]);
    weights += weight;
  }
  return glm::vec3(sum / weights);
}

}  // namespace

// After Germer, Uelwer, Conrad and Harmeling 2020. Differs: in linear light, where light really
// mixes; each level averages four pixels of the finer one; all pixels of a round see the round
// before, so the answer does not depend on the order.
Image<glm::vec3> estimate_foreground(const Image<glm::vec3>& linear, const Image<float>& alpha,
                                     Progress& progress) {
  if (alpha.empty()) return {};
  const std::vector<Level> levels = pyramid(linear, alpha);
  Layers layers{Image<glm::vec3>(1, 1, mean_colour(levels.front(), true)),
                Image<glm::vec3>(1, 1, mean_colour(levels.front(), false))};
  for (std::size_t i = levels.size(); i-- > 0;) {
    const int width = levels[i].alpha.width(), height = levels[i].alpha.height();
    if (width != layers.front.width() || height != layers.front.height()) {
      layers = {enlarged(layers.front, width, height), enlarged(layers.back, width, height)};
    }
    refine(levels[i], layers, progress);
  }
  progress.advance(std::size_t(alpha.height()));
  return layers.front;
}

}  // namespace bosk
