#include "core/phantom/scribbles.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"

namespace bosk {
namespace {

constexpr std::uint8_t kTree = 255, kBackground = 0, kUnknown = 128;
constexpr int kTreeStrokes = 28, kBackgroundStrokes = 16;

Image<float> blurred(const Image<float>& image, int radius) {
  Image<float> result(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      float sum = 0.0f;
      int count = 0;
      for (int v = std::max(0, y - radius); v <= std::min(image.height() - 1, y + radius); ++v) {
        for (int u = std::max(0, x - radius); u <= std::min(image.width() - 1, x + radius); ++u) {
          sum += image(u, v);
          ++count;
        }
      }
      result(x, y) = sum / float(count);
    }
  }
  return result;
}

// What the brush is for: where strokes like to go, and which pixels they may touch.
struct Brush {
  const Image<float>& liking;   // 0 to 1
  const Image<float>& allowed;  // 0 or 1
  float least_liking = 0.5f;
  double radius = 2.5;
  std::uint8_t value = kTree;
};

void dab(const Brush& brush, const glm::dvec2& at, Image<std::uint8_t>& strokes) {
  const int reach = int(std::ceil(brush.radius));
  for (int y = int(at.y) - reach; y <= int(at.y) + reach + 1; ++y) {
    for (int x = int(at.x) - reach; x <= int(at.x) + reach + 1; ++x) {
      if (x < 0 || y < 0 || x >= strokes.width() || y >= strokes.height()) continue;
      if (std::hypot(x - at.x, y - at.y) > brush.radius || brush.allowed(x, y) < 0.5f) continue;
      strokes(x, y) = brush.value;
    }
  }
}

float liking_at(const Brush& brush, const glm::dvec2& at) {
  const int x = int(std::lround(at.x)), y = int(std::lround(at.y));
  if (x < 0 || y < 0 || x >= brush.liking.width() || y >= brush.liking.height()) return -1.0f;
  return brush.liking(x, y);
}

// Goes on in the best of a few directions near the last one, until nothing there is liked.
void draw_stroke(const Brush& brush, glm::dvec2 at, double heading, double length, Random& random,
                 Image<std::uint8_t>& strokes) {
  for (double drawn = 0.0; drawn < length; drawn += 1.0) {
    dab(brush, at, strokes);
    double best = 0.0;
    float most = -1.0f;
    for (int k = 0; k < 7; ++k) {
      const double turn = heading + random.uniform(-0.5, 0.5);
      const float liked = liking_at(brush, at + 4.0 * glm::dvec2(std::cos(turn), std::sin(turn)));
      if (liked > most) most = liked, best = turn;
    }
    if (most < brush.least_liking) return;
    heading = best;
    at += glm::dvec2(std::cos(heading), std::sin(heading));
  }
}

void draw_strokes(const Brush& brush, int count, double length, Random& random,
                  Image<std::uint8_t>& strokes) {
  const int width = strokes.width(), height = strokes.height();
  int drawn = 0;
  for (int attempt = 0; attempt < 4000 && drawn < count; ++attempt) {
    const glm::dvec2 at{random.uniform(0.0, width - 1.0), random.uniform(0.0, height - 1.0)};
    if (liking_at(brush, at) < brush.least_liking) continue;
    draw_stroke(brush, at, random.uniform(0.0, 6.283185307), length * random.uniform(0.5, 1.3),
                random, strokes);
    ++drawn;
  }
}

// Up the trunk from its lowest opaque pixel near the middle of the tree.
void draw_trunk(const Brush& brush, Random& random, Image<std::uint8_t>& strokes) {
  const int width = strokes.width();
  for (int y = strokes.height() - 1; y >= strokes.height() / 3; --y) {
    for (int x = width / 3; x < 2 * width / 3; ++x) {
      if (brush.allowed(x, y) < 0.5f) continue;
      constexpr double kUp = -1.5707963;
      return draw_stroke(brush, {x, y - 2}, kUp, 0.15 * strokes.height(), random, strokes);
    }
  }
}

// A touch on each ball that shows: their colours are nowhere else.
void draw_markers(const PhantomView& view, const Brush& brush, Random& random,
                  Image<std::uint8_t>& strokes) {
  for (std::size_t i = 0; i < view.marker_px.size(); ++i) {
    if (view.marker_visible[i] < 0.5 || liking_at(brush, view.marker_px[i]) < 0.5f) continue;
    const double heading = random.uniform(0.0, 6.283185307);
    draw_stroke(brush, view.marker_px[i], heading, 4.0 * brush.radius, random, strokes);
  }
}

}  // namespace

Image<std::uint8_t> draw_scribbles(const PhantomView& view, std::uint64_t seed) {
  const int width = view.matte.width(), height = view.matte.height();
  Image<float> alpha(width, height), opaque(width, height), clear(width, height);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    alpha.pixels()[i] = float(view.matte.pixels()[i].a) / 255.0f;
    const bool hidden = view.in_front.pixels()[i] != 0;
    opaque.pixels()[i] = !hidden && alpha.pixels()[i] >= 0.95f ? 1.0f : 0.0f;
  }
  const Image<float> near = blurred(alpha, 2), closed = blurred(opaque, 3);
  for (std::size_t i = 0; i < clear.size(); ++i) {
    clear.pixels()[i] = near.pixels()[i] == 0.0f ? 1.0f : 0.0f;
  }
  const Image<float> open = blurred(clear, 3);
  const double thickness = std::clamp(width / 480.0, 0.5, 1.4);
  Image<std::uint8_t> strokes(width, height, kUnknown);
  Random random(seed, 11);
  const Brush tree{closed, opaque, 0.4f, 2.5 * thickness, kTree};
  const Brush background{open, clear, 0.9f, 3.5 * thickness, kBackground};
  draw_strokes(background, kBackgroundStrokes, 0.3 * width, random, strokes);
  draw_markers(view, background, random, strokes);
  draw_strokes(tree, kTreeStrokes, 0.16 * width, random, strokes);
  draw_trunk({closed, opaque, 0.1f, 2.5 * thickness, kTree}, random, strokes);
  return strokes;
}

}  // namespace bosk
