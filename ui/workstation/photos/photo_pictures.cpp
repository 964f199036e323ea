#include "ui/workstation/photos/photo_pictures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/image/colour.h"
#include "core/image/image_io.h"
#include "core/image/orientation.h"
#include "core/photo/pixel_source.h"

namespace bosk {
namespace {

glm::ivec2 shown_size(const DecodedPhoto& photo, int longest_px) {
  const int longest = std::max(photo.width_px, photo.height_px);
  const double shrink = std::min(1.0, double(longest_px) / std::max(1, longest));
  return {std::max(1, int(std::lround(photo.width_px * shrink))),
          std::max(1, int(std::lround(photo.height_px * shrink)))};
}

glm::u8vec4 encoded(const glm::vec4& light) {
  // Clear pixels keep no colour; a viewer shows nothing of them
  if (!(light.a > 0.0f)) return glm::u8vec4(0);
  const glm::vec3 srgb = srgb_from_linear(glm::vec3(light) / light.a);
  return {byte_from_unit(srgb.r), byte_from_unit(srgb.g), byte_from_unit(srgb.b),
          byte_from_unit(light.a)};
}

template <class Source>
glm::vec4 mean_light(const Source& source, const glm::ivec2& from, const glm::ivec2& to) {
  glm::vec4 sum(0.0f);
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) {
      const glm::vec4 pixel = source.straight_linear(x, y);
      sum += glm::vec4(glm::vec3(pixel) * pixel.a, pixel.a);
    }
  }
  return sum / float((to.x - from.x) * (to.y - from.y));
}

int edge(int index, int shown, int all) { return int(std::int64_t(index) * all / shown); }

}  // namespace

Image<glm::u8vec4> shown_photo(const DecodedPhoto& photo, int longest_px) {
  const glm::ivec2 size = shown_size(photo, longest_px);
  Image<glm::u8vec4> shown(size.x, size.y);
  visit_pixels(photo, [&](const auto& source) {
    tbb::parallel_for(0, size.y, [&](int y) {
      const int top = edge(y, size.y, photo.height_px);
      const int bottom = edge(y + 1, size.y, photo.height_px);
      for (int x = 0; x < size.x; ++x) {
        const int left = edge(x, size.x, photo.width_px);
        const int right = edge(x + 1, size.x, photo.width_px);
        shown(x, y) = encoded(mean_light(source, {left, top}, {right, bottom}));
      }
    });
  });
  return upright(shown, photo.metadata.orientation);
}

}  // namespace bosk
