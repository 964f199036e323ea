#pragma once

#include <Eigen/Core>
#include <glm/glm.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/calibrate/features.h"

namespace bosk {

// The features of one photo, the strongest first. For the files of this folder alone.
struct PhotoFeatures {
  std::vector<glm::dvec2> pixel;
  std::vector<float> size_px;  // diameter of what a descriptor describes
  // One row each, of unit length: square roots of SIFT's histogram (Arandjelovic and Zisserman
  // 2012, "Three things everyone should know to improve object retrieval").
  Eigen::Matrix<float, Eigen::Dynamic, 128, Eigen::RowMajor> descriptors;
};

// SIFT (Lowe 2004), by OpenCV.
PhotoFeatures detect_features(const FeaturePhoto& photo, int most);

// Features of two photos that show one point, as far as two photos can tell.
struct FeatureMatches {
  std::size_t first = 0, second = 0;       // photos
  std::vector<std::pair<int, int>> pairs;  // of features
};

// Each other's nearest, clearly nearer than the second; then those that one epipolar geometry
// explains (fundamental matrix by RANSAC). Empty where fewer than `fewest_matches` agree.
std::vector<std::pair<int, int>> match_features(const PhotoFeatures& first,
                                                const PhotoFeatures& second,
                                                const FeatureOptions& options);

// All pairs of photos that can show the same: neighbours in the walk in full; of others first only
// the strongest features, then, where these match, all. Empty pairs are left out.
std::vector<FeatureMatches> match_photos(std::span<const PhotoFeatures> photos,
                                         const FeatureOptions& options, Progress& progress);

}  // namespace bosk
