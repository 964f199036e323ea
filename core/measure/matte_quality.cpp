#include "core/measure/matte_quality.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/measure/cv_view.h"

namespace bosk {
namespace {

constexpr double kSigma_px = 1.4;

// First derivative of a Gaussian along one axis, the Gaussian along the other; 11 taps.
cv::Mat gradient_magnitude(const cv::Mat& alpha) {
  const int half = int(std::ceil(3.0 * kSigma_px));
  std::vector<double> smooth, slope;
  double sum = 0.0;
  for (int x = -half; x <= half; ++x) {
    smooth.push_back(std::exp(-x * x / (2.0 * kSigma_px * kSigma_px)));
    sum += smooth.back();
  }
  slope.reserve(smooth.size());
  for (double& weight : smooth) {
    const int x = int(slope.size()) - half;
    weight /= sum;
    slope.push_back(-x / (kSigma_px * kSigma_px) * weight);
  }
  cv::Mat along_x, along_y, magnitude;
  cv::sepFilter2D(alpha, along_x, CV_64F, slope, smooth);
  cv::sepFilter2D(alpha, along_y, CV_64F, smooth, slope);
  cv::magnitude(along_x, along_y, magnitude);
  return magnitude;
}

Image<double> alpha_of(const Image<glm::dvec4>& matte) {
  Image<double> alpha(matte.width(), matte.height());
  for (std::size_t i = 0; i < matte.size(); ++i) alpha.pixels()[i] = matte.pixels()[i].a;
  return alpha;
}

double foreground_error(const Image<glm::dvec4>& matte, const Image<glm::dvec4>& truth) {
  double weight = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::dvec3 error = glm::dvec3(matte.pixels()[i]) - glm::dvec3(truth.pixels()[i]);
    weight += truth.pixels()[i].a;
    sum += truth.pixels()[i].a * glm::dot(error, error);
  }
  return 255.0 * std::sqrt(sum / std::max(weight, 1e-9) / 3.0);
}

}  // namespace

MatteScore score_matte(const Image<glm::dvec4>& matte, const Image<glm::dvec4>& truth) {
  if (matte.width() != truth.width() || matte.height() != truth.height() || truth.empty()) {
    throw Error("the matte and its true matte differ in size, or are empty");
  }
  const Image<double> alpha = alpha_of(matte), true_alpha = alpha_of(truth);
  const double pixels = double(truth.size()), thousand_megapixels = pixels / 1e6 * 1000.0;
  MatteScore score;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double error = alpha.pixels()[i] - true_alpha.pixels()[i];
    score.sad += std::abs(error) / thousand_megapixels;
    score.mse += error * error * 1000.0 / pixels;
    score.bias += error / pixels;
  }
  const cv::Mat slope =
      gradient_magnitude(cv_view(alpha)) - gradient_magnitude(cv_view(true_alpha));
  score.grad = slope.dot(slope) / thousand_megapixels;
  score.foreground = foreground_error(matte, truth);
  return score;
}

}  // namespace bosk
