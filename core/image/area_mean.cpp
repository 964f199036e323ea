#include "core/image/area_mean.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/image/colour.h"

namespace bosk {
namespace {

// The pixels of a row (or column) that a smaller pixel covers, and how much of each.
struct Span {
  int first = 0;
  std::vector<float> weights;  // sum to 1
};

std::vector<Span> spans(int large, int small) {
  const double ratio = double(large) / small;
  std::vector<Span> result(std::size_t(small), Span{});
  for (int i = 0; i < small; ++i) {
    Span& span = result[std::size_t(i)];
    const double from = i * ratio, to = std::min((i + 1) * ratio, double(large));
    span.first = int(from);
    for (int k = span.first; k < std::min(int(std::ceil(to - 1e-9)), large); ++k) {
      span.weights.push_back(float((std::min(k + 1.0, to) - std::max(double(k), from)) / ratio));
    }
  }
  return result;
}

template <class T, class Light>
Image<T> averaged(const Image<T>& image, int width, int height, Light light) {
  Image<T> small(width, height);
  const std::vector<Span> columns = spans(image.width(), width);
  const std::vector<Span> rows = spans(image.height(), height);
  tbb::parallel_for(0, height, [&](int y) {
    const Span& row = rows[std::size_t(y)];
    for (std::size_t v = 0; v < row.weights.size(); ++v) {
      for (int x = 0; x < width; ++x) {
        const Span& column = columns[std::size_t(x)];
        T sum(0.0f);
        for (std::size_t u = 0; u < column.weights.size(); ++u) {
          sum += column.weights[u] * light(image(column.first + int(u), row.first + int(v)));
        }
        small(x, y) += row.weights[v] * sum;
      }
    }
  });
  return small;
}

}  // namespace

Image<float> area_mean(const Image<float>& values, int width, int height) {
  return averaged(values, width, height, [](float value) { return value; });
}

Image<glm::vec3> area_mean(const Image<glm::vec3>& linear, int width, int height) {
  return averaged(linear, width, height, [](const glm::vec3& value) { return value; });
}

Image<glm::vec3> area_mean_srgb(const Image<glm::vec3>& srgb, int width, int height) {
  Image<glm::vec3> mean =
      averaged(srgb, width, height, [](const glm::vec3& value) { return linear_from_srgb(value); });
  for (glm::vec3& value : mean.pixels()) value = srgb_from_linear(value);
  return mean;
}

Image<glm::vec4> area_mean_straight(const Image<glm::vec4>& straight, int width, int height) {
  Image<glm::vec4> mean = averaged(straight, width, height, [](const glm::vec4& value) {
    return glm::vec4(glm::vec3(value) * value.a, value.a);
  });
  for (glm::vec4& value : mean.pixels()) {
    if (value.a > 0.0f) value = glm::vec4(glm::vec3(value) / value.a, value.a);
  }
  return mean;
}

}  // namespace bosk
