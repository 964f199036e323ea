#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace bosk {

// Row-major pixels, row 0 at the top. Pixel (0, 0) is the centre of the top-left pixel, so the image
// covers [-0.5, width - 0.5] x [-0.5, height - 0.5].
template <class T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, const T& fill = T{})
      : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height), fill) {
    assert(width >= 0 && height >= 0);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }
  std::size_t size() const { return pixels_.size(); }
  T* data() { return pixels_.data(); }
  const T* data() const { return pixels_.data(); }

  T& operator()(int x, int y) { return pixels_[index(x, y)]; }
  const T& operator()(int x, int y) const { return pixels_[index(x, y)]; }

  std::vector<T>& pixels() { return pixels_; }
  const std::vector<T>& pixels() const { return pixels_; }

  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int x, int y) const {
    assert(x >= 0 && x < width_ && y >= 0 && y < height_);
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }

  int width_ = 0, height_ = 0;
  std::vector<T> pixels_;
};

}  // namespace bosk
