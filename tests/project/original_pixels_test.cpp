#include "core/project/original_pixels.h"

#include <gtest/gtest.h>

#include "core/photo/resample.h"

namespace bosk {
namespace {

Photo photo_through(const Lens& original) {
  Photo photo;
  photo.original_camera.lens = original;
  photo.camera.lens = undistorted(original);
  return photo;
}

// Smooth, so that resampling twice costs little.
Image<glm::vec4> smooth_picture(int width, int height) {
  Image<glm::vec4> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float u = float(x) / float(width), v = float(y) / float(height);
      picture(x, y) = {u, v, 0.5f, 0.5f + 0.5f * u * v};
    }
  }
  return picture;
}

TEST(OriginalPixels, AreTheWorkingPixelsWhereTheLensIsAPinhole) {
  const Lens lens{LensModel::pinhole, 40, 30, {50.0, 50.0}, {19.5, 14.5}, {}};
  const Image<glm::vec4> picture = smooth_picture(40, 30);
  const Image<glm::vec4> result = in_original_pixels(picture, photo_through(lens));
  for (std::size_t i = 0; i < picture.size(); ++i) {
    // Projecting there and back is exact to 1e-9 px; the rest is rounding to float
    EXPECT_LT(glm::length(result.data()[i] - picture.data()[i]), 1e-5f);
  }
}

TEST(OriginalPixels, UndoTheUndistortion) {
  Lens lens{LensModel::opencv, 160, 120, {180.0, 180.0}, {79.5, 59.5}, {}};
  lens.distortion[0] = -0.06;
  const Photo photo = photo_through(lens);
  const Image<glm::vec4> original = smooth_picture(160, 120);
  const Image<glm::vec4> working = undistort_rgba(original, photo.original_camera, photo.camera);
  const Image<glm::vec4> result = in_original_pixels(working, photo);
  for (int y = 10; y < 110; ++y) {
    for (int x = 10; x < 150; ++x) {
      // Two interpolations of a ramp whose colour mean is taken in linear light: well under a grey
      // level
      EXPECT_LT(glm::length(result(x, y) - original(x, y)), 2e-3f) << x << " " << y;
    }
  }
}

}  // namespace
}  // namespace bosk
