#include "core/image/pyramid.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/image/colour.h"

namespace bosk {
namespace {

// `to_light` prepares a pixel for averaging, `from_light` turns the mean back.
template <class T, class ToLight, class FromLight>
Image<T> halved(const Image<T>& image, ToLight to_light, FromLight from_light) {
  Image<T> half((image.width() + 1) / 2, (image.height() + 1) / 2);
  tbb::parallel_for(0, half.height(), [&](int y) {
    const int rows = std::min(2, image.height() - 2 * y);
    for (int x = 0; x < half.width(); ++x) {
      const int columns = std::min(2, image.width() - 2 * x);
      T sum(0.0f);
      for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
          sum += to_light(image(2 * x + column, 2 * y + row));
        }
      }
      half(x, y) = from_light(sum / float(rows * columns));
    }
  });
  return half;
}

template <class T>
Image<T> plain_half(const Image<T>& image) {
  const auto same = [](const T& value) { return value; };
  return halved(image, same, same);
}

// An alpha too small to see, given to every pixel while averaging: it keeps the colour of clear
// areas.
constexpr float kTrace = 1e-6f;

glm::vec4 premultiplied_linear(const glm::vec4& straight) {
  const float weight = straight.a + kTrace;
  return {linear_from_srgb(glm::vec3(straight)) * weight, weight};
}

glm::vec4 straight_srgb(const glm::vec4& premultiplied) {
  const glm::vec3 linear = glm::vec3(premultiplied) / premultiplied.a;
  return {srgb_from_linear(linear), std::max(0.0f, premultiplied.a - kTrace)};
}

}  // namespace

Image<float> half_size(const Image<float>& values) { return plain_half(values); }
Image<glm::vec3> half_size(const Image<glm::vec3>& linear) { return plain_half(linear); }
Image<glm::vec4> half_size(const Image<glm::vec4>& premultiplied) {
  return plain_half(premultiplied);
}

Image<glm::vec3> half_size_srgb(const Image<glm::vec3>& srgb) {
  return halved(
      srgb, [](const glm::vec3& v) { return linear_from_srgb(v); },
      [](const glm::vec3& v) { return srgb_from_linear(v); });
}

Image<glm::vec4> half_size_straight(const Image<glm::vec4>& straight) {
  return halved(straight, premultiplied_linear, straight_srgb);
}

std::vector<Image<glm::vec3>> pyramid_srgb(const Image<glm::vec3>& srgb, int smallest_px) {
  std::vector<Image<glm::vec3>> levels{srgb};
  while (std::max(levels.back().width(), levels.back().height()) > std::max(1, smallest_px)) {
    levels.push_back(half_size_srgb(levels.back()));
  }
  return levels;
}

}  // namespace bosk
