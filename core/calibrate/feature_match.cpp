#include "core/calibrate/feature_match.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "core/calibrate/grey_image.h"

namespace bosk {
namespace {

constexpr int kNeighbours = 4;         // photos in the walk that are matched in full
constexpr int kStrongest = 600;        // features that other photos are tried with
constexpr std::size_t kPromising = 8;  // matches among these that are worth a full look

using Descriptors = Eigen::Matrix<float, Eigen::Dynamic, 128, Eigen::RowMajor>;

cv::Mat mask_of(const FeaturePhoto& photo) {
  if (!photo.mask) return {};
  cv::Mat mask(photo.mask->height(), photo.mask->width(), CV_8U);
  std::copy(photo.mask->pixels().begin(), photo.mask->pixels().end(), mask.begin<std::uint8_t>());
  return mask;
}

Descriptors root_descriptors(const cv::Mat& sift) {
  Descriptors result(sift.rows, 128);
  for (int row = 0; row < sift.rows; ++row) {
    for (int i = 0; i < 128; ++i) result(row, i) = sift.at<float>(row, i);
    result.row(row) /= std::max(result.row(row).lpNorm<1>(), 1e-6f);
    result.row(row) = result.row(row).cwiseSqrt();
  }
  return result;
}

struct Nearest {
  int index = -1;
  float best = -1.0f, second = -1.0f;  // cosines
  void offer(int candidate, float cosine) {
    if (cosine > best) {
      second = best;
      best = cosine;
      index = candidate;
    } else if (cosine > second) {
      second = cosine;
    }
  }
  // Distances of unit vectors: |a - b|^2 = 2 - 2 cos.
  bool is_clear(double ratio) const {
    return index >= 0 && 2.0 - 2.0 * double(best) < ratio * ratio * (2.0 - 2.0 * double(second));
  }
};

using Pairs = std::vector<std::pair<int, int>>;

// Cosines are made a block of rows at a time, to stay in the cache.
Pairs mutual_nearest(const Descriptors& a, const Descriptors& b, double ratio) {
  constexpr Eigen::Index kBlock = 128;
  std::vector<Nearest> of_a(std::size_t(a.rows())), of_b(std::size_t(b.rows()));
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> cosines;
  for (Eigen::Index begin = 0; begin < a.rows(); begin += kBlock) {
    const Eigen::Index rows = std::min(kBlock, a.rows() - begin);
    cosines.noalias() = a.middleRows(begin, rows) * b.transpose();
    for (Eigen::Index row = 0; row < rows; ++row)
      for (Eigen::Index column = 0; column < b.rows(); ++column) {
        const float cosine = cosines(row, column);
        of_a[std::size_t(begin + row)].offer(int(column), cosine);
        of_b[std::size_t(column)].offer(int(begin + row), cosine);
      }
  }
  Pairs pairs;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const int other = of_a[i].index;
    if (other < 0 || of_b[std::size_t(other)].index != int(i)) continue;
    if (of_a[i].is_clear(ratio) && of_b[std::size_t(other)].is_clear(ratio))
      pairs.emplace_back(int(i), other);
  }
  return pairs;
}

Pairs on_epipolar_lines(const PhotoFeatures& first, const PhotoFeatures& second, const Pairs& pairs,
                        const FeatureOptions& options) {
  if (int(pairs.size()) < std::max(8, options.fewest_matches)) return {};
  std::vector<cv::Point2d> a, b;
  for (const auto& [i, j] : pairs) {
    const glm::dvec2 &p = first.pixel[std::size_t(i)], &q = second.pixel[std::size_t(j)];
    a.emplace_back(p.x, p.y);
    b.emplace_back(q.x, q.y);
  }
  std::vector<std::uint8_t> agrees;
  cv::findFundamentalMat(a, b, cv::FM_RANSAC, options.largest_error_px, 0.9999, 4000, agrees);
  Pairs kept;
  for (std::size_t i = 0; i < agrees.size(); ++i)
    if (agrees[i]) kept.push_back(pairs[i]);
  if (int(kept.size()) < options.fewest_matches) return {};
  return kept;
}

bool is_promising(const PhotoFeatures& first, const PhotoFeatures& second,
                  const FeatureOptions& options) {
  const auto strongest = [](const PhotoFeatures& photo) -> Descriptors {
    return photo.descriptors.topRows(std::min<Eigen::Index>(kStrongest, photo.descriptors.rows()));
  };
  return mutual_nearest(strongest(first), strongest(second), options.ratio).size() >= kPromising;
}

bool are_neighbours(std::size_t first, std::size_t second, std::size_t photos) {
  const std::size_t apart = second - first;
  return apart <= std::size_t(kNeighbours) || apart + std::size_t(kNeighbours) >= photos;
}

}  // namespace

PhotoFeatures detect_features(const FeaturePhoto& photo, int most) {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
  const auto sift = cv::SIFT::create(most, 3, 0.02, 10.0, 1.6);
  sift->detectAndCompute(grey_of(*photo.srgb), mask_of(photo), keypoints, descriptors);
  PhotoFeatures features;
  for (const cv::KeyPoint& keypoint : keypoints) {
    features.pixel.emplace_back(keypoint.pt.x, keypoint.pt.y);
    features.size_px.push_back(keypoint.size);
  }
  features.descriptors = root_descriptors(descriptors);
  return features;
}

std::vector<std::pair<int, int>> match_features(const PhotoFeatures& first,
                                                const PhotoFeatures& second,
                                                const FeatureOptions& options) {
  return on_epipolar_lines(
      first, second, mutual_nearest(first.descriptors, second.descriptors, options.ratio), options);
}

std::vector<FeatureMatches> match_photos(std::span<const PhotoFeatures> photos,
                                         const FeatureOptions& options, Progress& progress) {
  std::vector<FeatureMatches> matches;
  for (std::size_t first = 0; first < photos.size(); ++first)
    for (std::size_t second = first + 1; second < photos.size(); ++second)
      matches.push_back({first, second, {}});
  progress.begin("Matching features", matches.size(), 0.3, 0.8);
  tbb::parallel_for(std::size_t(0), matches.size(), [&](std::size_t i) {
    FeatureMatches& match = matches[i];
    progress.advance();
    const PhotoFeatures &first = photos[match.first], &second = photos[match.second];
    if (are_neighbours(match.first, match.second, photos.size()) ||
        is_promising(first, second, options))
      match.pairs = match_features(first, second, options);
  });
  std::erase_if(matches, [](const FeatureMatches& match) { return match.pairs.empty(); });
  return matches;
}

}  // namespace bosk
