#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>

#include "core/image/image.h"

// Private to this folder: the header shows OpenCV.
namespace bosk {

// The picture as OpenCV sees it, not copied; it must outlive the view.
inline cv::Mat cv_grey(const Image<std::uint8_t>& grey) {
  return cv::Mat(grey.height(), grey.width(), CV_8UC1, const_cast<std::uint8_t*>(grey.data()));
}

struct RefinedCorner {
  glm::dvec2 pixel{0.0};
  double sigma_px = 0.1;
};

// The picture shrunk to at most that many pixels, by area means; itself where it has fewer.
cv::Mat at_most(const cv::Mat& grey, double megapixels);

// Standard deviation of a picture's noise around `centre`, in grey levels, at least that of
// rounding. Immerkaer 1996, "Fast noise variance estimation": the difference of two Laplacians,
// which lines and slopes leave near zero. Differs: the median of its magnitude instead of the mean,
// for the edges of a board are many.
double grey_noise(const cv::Mat& grey, const cv::Rect& around);

// A refining window's half side over the way to the next corner.
inline constexpr double kWindowShare = 0.33;

// The point near `start` where edges cross: cv::cornerSubPix in a window that reaches
// kWindowShare of the way to the next corner, which is `spacing_px` away. sigma_px propagates
// `noise` through that method: the corner c solves sum g g^T (p - c) = 0 over the window's pixels p
// with gradients g.
RefinedCorner refined_corner(const cv::Mat& grey, const glm::dvec2& start, double spacing_px,
                             double noise);

}  // namespace bosk
