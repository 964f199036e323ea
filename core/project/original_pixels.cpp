#include "core/project/original_pixels.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <optional>

namespace bosk {
namespace {

glm::vec4 premultiplied(const glm::vec4& straight) {
  return {glm::vec3(straight) * straight.a, straight.a};
}

glm::vec4 straight(const glm::vec4& premultiplied) {
  if (premultiplied.a <= 0.0f) return glm::vec4(0.0f);
  return {glm::vec3(premultiplied) / premultiplied.a, premultiplied.a};
}

glm::vec4 pixel_or_clear(const Image<glm::vec4>& image, int x, int y) {
  const bool inside = x >= 0 && y >= 0 && x < image.width() && y < image.height();
  return inside ? premultiplied(image(x, y)) : glm::vec4(0.0f);
}

glm::vec4 bilinear(const Image<glm::vec4>& image, const glm::dvec2& pixel) {
  const glm::dvec2 corner = glm::floor(pixel);
  const glm::vec2 part(pixel - corner);
  const int x = int(corner.x), y = int(corner.y);
  const glm::vec4 upper =
      glm::mix(pixel_or_clear(image, x, y), pixel_or_clear(image, x + 1, y), part.x);
  const glm::vec4 lower =
      glm::mix(pixel_or_clear(image, x, y + 1), pixel_or_clear(image, x + 1, y + 1), part.x);
  return straight(glm::mix(upper, lower, part.y));
}

bool is_near(const Image<glm::vec4>& image, const glm::dvec2& pixel) {
  return pixel.x > -1.0 && pixel.y > -1.0 && pixel.x < image.width() && pixel.y < image.height();
}

}  // namespace

Image<glm::vec4> in_original_pixels(const Image<glm::vec4>& working, const Photo& photo) {
  const Lens& original = photo.original_camera.lens;
  Image<glm::vec4> result(original.width_px, original.height_px);
  tbb::parallel_for(0, original.height_px, [&](int y) {
    for (int x = 0; x < original.width_px; ++x) {
      const auto direction = camera_from_pixel(original, {x, y});
      if (!direction) continue;
      const auto pixel = pixel_from_camera(photo.camera.lens, *direction);
      if (pixel && is_near(working, *pixel)) result(x, y) = bilinear(working, *pixel);
    }
  });
  return result;
}

}  // namespace bosk
