#include "core/calibrate/ball_candidates.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <span>

namespace bosk {
namespace {

constexpr std::array kRadii{2.6, 3.4, 4.5, 6.0, 8.0};
constexpr float kLeastStrength = 7.0f;

cv::Mat smoothed(const cv::Mat& saturation, double sigma) {
  cv::Mat result;
  cv::GaussianBlur(saturation, result, cv::Size(), sigma, sigma, cv::BORDER_REPLICATE);
  return result;
}

// How far the colour inside stands off from that around it, along its own direction.
cv::Mat standing_off(const cv::Mat& saturation, double radius) {
  const cv::Mat inside = smoothed(saturation, 0.5 * radius);
  const cv::Mat around = smoothed(saturation, 1.2 * radius);
  cv::Mat strength(saturation.rows, saturation.cols, CV_32F);
  for (int y = 0; y < saturation.rows; ++y)
    for (int x = 0; x < saturation.cols; ++x) {
      const cv::Vec2f in = inside.at<cv::Vec2f>(y, x), out = around.at<cv::Vec2f>(y, x);
      const float chroma = std::max(std::hypot(in[0], in[1]), 1.0f);
      strength.at<float>(y, x) = (in - out).dot(in) / chroma;
    }
  return strength;
}

bool is_maximum(std::span<const cv::Mat> scales, int scale, int x, int y) {
  const float value = scales[std::size_t(scale)].at<float>(y, x);
  for (int s = std::max(0, scale - 1); s <= std::min(int(scales.size()) - 1, scale + 1); ++s)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (scales[std::size_t(s)].at<float>(y + dy, x + dx) > value) return false;
  return true;
}

void collect_maxima(std::span<const cv::Mat> scales, int scale, std::vector<BallCandidate>& found) {
  const cv::Mat& strength = scales[std::size_t(scale)];
  for (int y = 1; y + 1 < strength.rows; ++y)
    for (int x = 1; x + 1 < strength.cols; ++x)
      if (strength.at<float>(y, x) >= kLeastStrength && is_maximum(scales, scale, x, y))
        found.push_back({{x, y}, kRadii[std::size_t(scale)], strength.at<float>(y, x)});
}

cv::Mat two_channels(const Image<glm::vec3>& saturation) {
  cv::Mat channels(saturation.height(), saturation.width(), CV_32FC2);
  for (int y = 0; y < saturation.height(); ++y)
    for (int x = 0; x < saturation.width(); ++x)
      channels.at<cv::Vec2f>(y, x) = {saturation(x, y).x, saturation(x, y).y};
  return channels;
}

}  // namespace

std::vector<BallCandidate> find_blobs(const Image<glm::vec3>& saturation, std::size_t most) {
  const cv::Mat channels = two_channels(saturation);
  std::vector<cv::Mat> scales;
  for (const double radius : kRadii) scales.push_back(standing_off(channels, radius));
  std::vector<BallCandidate> found;
  for (int scale = 0; scale < int(scales.size()); ++scale) collect_maxima(scales, scale, found);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.strength > b.strength; });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace bosk
