#include "core/measure/image_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <string>

#include "core/base/error.h"
#include "core/measure/colour_difference.h"
#include "core/measure/cv_view.h"

namespace bosk {
namespace {

constexpr int kCropMargin_px = 8;

void check_sizes(const Image<glm::u8vec4>& rendered, const Image<glm::u8vec4>& truth) {
  if (rendered.width() == truth.width() && rendered.height() == truth.height()) return;
  const auto size = [](const Image<glm::u8vec4>& image) {
    return std::to_string(image.width()) + " x " + std::to_string(image.height());
  };
  throw Error("the rendered view has " + size(rendered) + " pixels, its truth " + size(truth) +
              "; render it at the size of the truth");
}

cv::Rect crop_of(const Image<glm::u8vec4>& truth) {
  int left = truth.width(), top = truth.height(), right = -1, bottom = -1;
  for (int y = 0; y < truth.height(); ++y) {
    for (int x = 0; x < truth.width(); ++x) {
      if (truth(x, y).a == 0) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  }
  if (right < 0) throw Error("the true picture shows nothing: its alpha is 0 everywhere");
  const cv::Rect grown(cv::Point(left - kCropMargin_px, top - kCropMargin_px),
                       cv::Point(right + kCropMargin_px + 1, bottom + kCropMargin_px + 1));
  return grown & cv::Rect(0, 0, truth.width(), truth.height());
}

double mean_of(const cv::Mat& values) {
  const cv::Scalar sums = cv::sum(values);
  double sum = 0.0;
  for (int channel = 0; channel < values.channels(); ++channel) sum += sums[channel];
  return sum / double(values.total() * std::size_t(values.channels()));
}

double psnr_db(const cv::Mat& a, const cv::Mat& b) {
  const cv::Mat difference = a - b;
  const double mean_square = mean_of(difference.mul(difference));
  return mean_square == 0.0 ? 99.0 : -10.0 * std::log10(mean_square);
}

cv::Mat ssim_map(const cv::Mat& a, const cv::Mat& b) {
  constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
  const cv::Scalar c1 = cv::Scalar::all(kC1), c2 = cv::Scalar::all(kC2);
  const auto blur = [](const cv::Mat& from) {
    cv::Mat to;
    cv::GaussianBlur(from, to, cv::Size(11, 11), 1.5, 0.0, cv::BORDER_REFLECT_101);
    return to;
  };
  const cv::Mat mean_a = blur(a), mean_b = blur(b), mean_ab = mean_a.mul(mean_b);
  const cv::Mat square_a = mean_a.mul(mean_a), square_b = mean_b.mul(mean_b);
  const cv::Mat variance_a = blur(a.mul(a)) - square_a, variance_b = blur(b.mul(b)) - square_b;
  const cv::Mat covariance = blur(a.mul(b)) - mean_ab;
  const cv::Mat above = cv::Mat(2.0 * mean_ab + c1).mul(2.0 * covariance + c2);
  const cv::Mat below = cv::Mat(square_a + square_b + c1).mul(variance_a + variance_b + c2);
  return above / below;
}

// Sobel's mean magnitude; luma with the weights of Rec. 709, of encoded values.
double mean_gradient(const cv::Mat& rgb) {
  cv::Mat luma, along_x, along_y, magnitude;
  cv::transform(rgb, luma, cv::Matx13d(0.2126, 0.7152, 0.0722));
  cv::Sobel(luma, along_x, CV_64F, 1, 0);
  cv::Sobel(luma, along_y, CV_64F, 0, 1);
  cv::magnitude(along_x, along_y, magnitude);
  return mean_of(magnitude);
}

double edge_ratio(const cv::Mat& rendered, const cv::Mat& truth) {
  const double found = mean_gradient(rendered), wanted = mean_gradient(truth);
  if (wanted > 0.0) return found / wanted;
  return found > 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
}

double alpha_error(const Image<glm::u8vec4>& a, const Image<glm::u8vec4>& b, const cv::Rect& crop) {
  long long sum = 0;
  for (int y = crop.y; y < crop.y + crop.height; ++y) {
    for (int x = crop.x; x < crop.x + crop.width; ++x) sum += std::abs(a(x, y).a - b(x, y).a);
  }
  return double(sum) / 255.0 / double(crop.area());
}

double colour_error(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b, const cv::Rect& crop) {
  double sum = 0.0;
  for (int y = crop.y; y < crop.y + crop.height; ++y) {
    for (int x = crop.x; x < crop.x + crop.width; ++x) {
      if (a(x, y) != b(x, y)) sum += colour_difference_srgb(a(x, y), b(x, y));
    }
  }
  return sum / double(crop.area());
}

}  // namespace

Image<glm::dvec3> over_white(const Image<glm::u8vec4>& rgba) {
  Image<glm::dvec3> composite(rgba.width(), rgba.height());
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    const glm::dvec4 pixel = glm::dvec4(rgba.pixels()[i]) / 255.0;
    composite.pixels()[i] = glm::dvec3(pixel) * pixel.a + (1.0 - pixel.a);
  }
  return composite;
}

double psnr_db(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b) {
  return psnr_db(cv_view(a), cv_view(b));
}

Image<glm::dvec3> ssim_map(const Image<glm::dvec3>& a, const Image<glm::dvec3>& b) {
  Image<glm::dvec3> map(a.width(), a.height());
  ssim_map(cv_view(a), cv_view(b)).copyTo(cv_view(map));
  return map;
}

ViewScore score_view(const Image<glm::u8vec4>& rendered, const Image<glm::u8vec4>& truth) {
  check_sizes(rendered, truth);
  const cv::Rect crop = crop_of(truth);
  const Image<glm::dvec3> rendered_pixels = over_white(rendered), true_pixels = over_white(truth);
  const cv::Mat a = cv_view(rendered_pixels), b = cv_view(true_pixels), ssim = ssim_map(a, b);
  ViewScore score;
  score.psnr = psnr_db(a, b);
  score.ssim = mean_of(ssim);
  score.crop_psnr = psnr_db(a(crop), b(crop));
  score.crop_ssim = mean_of(ssim(crop));
  score.alpha_mae = alpha_error(rendered, truth, crop);
  score.edge_ratio = edge_ratio(a(crop), b(crop));
  score.colour_error = colour_error(rendered_pixels, true_pixels, crop);
  return score;
}

}  // namespace bosk
