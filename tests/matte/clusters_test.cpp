#include "core/matte/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bosk {
namespace {

std::vector<glm::vec3> three_colours() {
  std::vector<glm::vec3> lab;
  for (int i = 0; i < 300; ++i) {
    const float wobble = float(i % 7) - 3.0f;
    lab.push_back(glm::vec3(20.0f + 30.0f * float(i % 3), wobble, 0.0f));
  }
  return lab;
}

TEST(ClusterColours, FindsColoursThatLieApart) {
  const Clustering found = cluster_colours(three_colours(), 3, 0.1f);
  ASSERT_EQ(found.clusters.size(), 3u);
  std::vector<float> lightness;
  for (const ColourCluster& cluster : found.clusters) lightness.push_back(cluster.lab.x);
  std::sort(lightness.begin(), lightness.end());
  EXPECT_NEAR(lightness[0], 20.0f, 1e-3f);
  EXPECT_NEAR(lightness[1], 50.0f, 1e-3f);
  EXPECT_NEAR(lightness[2], 80.0f, 1e-3f);
}

TEST(ClusterColours, MeasuresTheSpread) {
  const Clustering found = cluster_colours(three_colours(), 3, 0.1f);
  for (const ColourCluster& cluster : found.clusters) {
    EXPECT_NEAR(cluster.covariance[0], 0.1f, 0.01f);        // lightness is constant: the floor
    EXPECT_NEAR(cluster.covariance[2], 4.0f + 0.1f, 0.3f);  // -3 to 3 in steps of 1: variance 4
    EXPECT_NEAR(cluster.share, 1.0f / 3.0f, 1e-5f);
  }
}

TEST(ClusterColours, FindsNoMoreClustersThanColours) {
  EXPECT_EQ(cluster_colours(std::vector<glm::vec3>(50, glm::vec3(40.0f, 5.0f, 5.0f)), 8, 1.0f)
                .clusters.size(),
            1u);
  EXPECT_EQ(cluster_colours({glm::vec3(1.0f), glm::vec3(9.0f)}, 8, 1.0f).clusters.size(), 2u);
  EXPECT_TRUE(cluster_colours({}, 8, 1.0f).clusters.empty());
}

TEST(ClusterColours, NamesTheClusterOfEachSample) {
  const auto lab = three_colours();
  const Clustering found = cluster_colours(lab, 3, 0.1f);
  ASSERT_EQ(found.cluster_of_sample.size(), lab.size());
  for (std::size_t i = 0; i < lab.size(); ++i) {
    const ColourCluster& cluster = found.clusters[std::size_t(found.cluster_of_sample[i])];
    EXPECT_NEAR(cluster.lab.x, lab[i].x, 1e-3f);
  }
}

}  // namespace
}  // namespace bosk
