#include "core/calibrate/board_refine.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace bosk {
namespace {

constexpr double kRoundingNoise = 0.29;  // of 8 bits: a step's standard deviation, 1 / sqrt(12)
// What print, lens and sensor leave in the sharpest photos besides noise; corners of real boards
// miss a good lens by 0.1 to 0.2 px, those of painted ones by 0.02.
constexpr double kSmallestSigma_px = 0.1;

int window_px(double spacing_px) { return std::clamp(int(kWindowShare * spacing_px), 2, 24); }

glm::dvec2 gradient(const cv::Mat& grey, int x, int y) {
  return 0.5 *
         glm::dvec2(double(grey.at<std::uint8_t>(y, x + 1)) - grey.at<std::uint8_t>(y, x - 1),
                    double(grey.at<std::uint8_t>(y + 1, x)) - grey.at<std::uint8_t>(y - 1, x));
}

double sigma_of(const cv::Mat& grey, const glm::dvec2& corner, int window, double noise) {
  glm::dmat2 normal(0.0), spread(0.0);
  const int cx = int(std::lround(corner.x)), cy = int(std::lround(corner.y));
  for (int y = std::max(1, cy - window); y <= std::min(grey.rows - 2, cy + window); ++y)
    for (int x = std::max(1, cx - window); x <= std::min(grey.cols - 2, cx + window); ++x) {
      const glm::dvec2 g = gradient(grey, x, y), away = glm::dvec2(x, y) - corner;
      const glm::dmat2 outer = glm::outerProduct(g, g);
      const double squared = glm::dot(away, away);
      const double weight = std::exp(-squared / double(window * window));  // cornerSubPix's own
      normal += weight * outer;
      spread += weight * weight * squared * outer;
    }
  if (!(glm::determinant(normal) > 0.0)) return double(window);
  const glm::dmat2 inverse = glm::inverse(normal);
  // A gradient, half the difference of two pixels, has half their variance.
  const glm::dmat2 covariance = 0.5 * noise * noise * inverse * spread * inverse;
  const double variance = 0.5 * (covariance[0][0] + covariance[1][1]);
  return std::sqrt(variance + kSmallestSigma_px * kSmallestSigma_px);
}

}  // namespace

cv::Mat at_most(const cv::Mat& grey, double megapixels) {
  const double scale = std::sqrt(megapixels * 1e6 / double(grey.total()));
  if (scale >= 1.0) return grey;
  cv::Mat small;
  cv::resize(grey, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

double grey_noise(const cv::Mat& grey, const cv::Rect& around) {
  const cv::Rect inside = around & cv::Rect(1, 1, grey.cols - 2, grey.rows - 2);
  std::vector<int> magnitudes;
  const int step = std::max(1, int(std::sqrt(double(inside.area()) / 40000.0)));
  for (int y = inside.y; y < inside.y + inside.height; y += step)
    for (int x = inside.x; x < inside.x + inside.width; x += step) {
      const auto at = [&](int dx, int dy) { return int(grey.at<std::uint8_t>(y + dy, x + dx)); };
      magnitudes.push_back(std::abs(at(-1, -1) + at(1, -1) + at(-1, 1) + at(1, 1) + 4 * at(0, 0) -
                                    2 * (at(0, -1) + at(0, 1) + at(-1, 0) + at(1, 0))));
    }
  if (magnitudes.empty()) return kRoundingNoise;
  const auto middle = magnitudes.begin() + std::ptrdiff_t(magnitudes.size() / 2);
  std::nth_element(magnitudes.begin(), middle, magnitudes.end());
  return std::max(kRoundingNoise, *middle / (0.6745 * 6.0));
}

RefinedCorner refined_corner(const cv::Mat& grey, const glm::dvec2& start, double spacing_px,
                             double noise) {
  const int window = window_px(spacing_px);
  std::vector<cv::Point2f> corner{{float(start.x), float(start.y)}};
  cv::cornerSubPix(grey, corner, {window, window}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 1e-3});
  const glm::dvec2 pixel(corner[0].x, corner[0].y);
  return {pixel, sigma_of(grey, pixel, window, noise)};
}

}  // namespace bosk
