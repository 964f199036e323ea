#include "meadow.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/image/colour.h"

namespace bosk {
namespace {

void mix_in(Image<glm::vec3>& image, int x, int y, const glm::vec3& linear, double share) {
  glm::vec3& pixel = image(x, y);
  pixel = srgb_from_linear(
      glm::mix(linear_from_srgb(pixel), linear, float(std::clamp(share, 0.0, 1.0))));
}

}  // namespace

Image<glm::vec3> meadow(int width, int height) {
  Random random(7, 1);
  Image<glm::vec3> image(width, height);
  for (glm::vec3& pixel : image.pixels())
    pixel = glm::vec3(0.42f, 0.5f, 0.28f) * float(random.uniform(0.85, 1.15));
  return image;
}

void draw_ball(Image<glm::vec3>& image, const glm::dvec2& centre, double radius,
               const glm::vec3& srgb) {
  const glm::vec3 colour = linear_from_srgb(srgb);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::dvec2 off = (glm::dvec2(x, y) - centre) / radius;
      const double distance = glm::length(off);
      if (distance > 1.0 + 1.0 / radius) continue;
      const double depth = std::sqrt(std::max(0.0, 1.0 - distance * distance));
      const double light = std::max(0.0, -0.4 * off.x - 0.6 * off.y + 0.7 * depth);
      mix_in(image, x, y, colour * float(0.25 + 0.6 * light), (1.0 - distance) * radius + 0.5);
    }
}

void draw_stick(Image<glm::vec3>& image, const glm::dvec2& top, double foot) {
  const glm::vec3 wood(0.45f, 0.33f, 0.22f);
  for (int y = int(top.y); y <= int(foot) + 1; ++y)
    for (int x = int(top.x) - 2; x <= int(top.x) + 3; ++x)
      mix_in(image, x, y, wood, std::min(1.5 - std::abs(x - top.x), foot - y + 0.5));
}

void draw_leaves(Image<glm::vec3>& image, double x, int left, int top, int bottom) {
  Random random(9, 1);
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= int(x); ++column)
      image(column, row) = glm::vec3(0.2f, 0.33f, 0.1f) * float(random.uniform(0.8, 1.2));
}

}  // namespace bosk
