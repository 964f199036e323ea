#include "core/matte/alpha.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/image/colour.h"

namespace bosk {
namespace {

const glm::vec3 kLeaf(0.03f, 0.09f, 0.02f), kSky(0.4f, 0.6f, 0.95f);  // linear light

StrokeCluster cluster_of(const glm::vec3& linear) {
  StrokeCluster cluster;
  cluster.colour.lab = lab_from_linear(linear);
  cluster.colour.variance = 4.0f;
  cluster.colour.covariance = {4.0f, 0.0f, 4.0f, 0.0f, 0.0f, 4.0f};
  cluster.colour.share = 1.0f;
  cluster.squared_distance = Image<float>(4, 4);
  return cluster;
}

StrokeModel leaf_and_sky() { return {{cluster_of(kLeaf)}, {cluster_of(kSky)}}; }

// One row whose alpha goes from 0 at the left to 1 at the right.
Image<glm::vec3> ramp(int width) {
  Image<glm::vec3> srgb(width, 1);
  for (int x = 0; x < width; ++x) {
    srgb(x, 0) = srgb_from_linear(glm::mix(kSky, kLeaf, float(x) / float(width - 1)));
  }
  return srgb;
}

AlphaEstimate estimate(const Image<glm::vec3>& srgb, const StrokeModel& model, float tilt,
                       const AlphaSettings& settings = {"curve", 0.1f, 0.0f}) {
  Progress progress;
  const LabPlanes lab = lab_planes(srgb, glm::vec3(1.0f), 1, progress);
  return estimate_alpha(lab, model, Image<float>(1, 1, tilt), settings, progress);
}

TEST(EstimateAlpha, MeasuresLightMixedFromTwoColours) {
  // So little belief in pure colours that only mixtures are left to explain a pixel
  const AlphaEstimate found = estimate(ramp(101), leaf_and_sky(), 0.0f, {"curve", 0.1f, -50.0f});
  for (int x = 0; x <= 100; ++x) {
    // A mixing path has 6 straight pieces; within one, alpha and length grow up to 0.01 apart
    EXPECT_NEAR(found.alpha(x, 0), float(x) / 100.0f, 0.012f);
  }
}

TEST(EstimateAlpha, SnapsToPureColoursWithinTheirSpread) {
  const AlphaEstimate doubtful = estimate(ramp(101), leaf_and_sky(), 0.0f, {"curve", 0.1f, -50.0f});
  const AlphaEstimate sure = estimate(ramp(101), leaf_and_sky(), 0.0f, {"curve", 0.1f, 4.0f});
  for (int x = 0; x <= 100; ++x) {
    const float alpha = doubtful.alpha(x, 0);
    if (alpha < 0.02f) {
      EXPECT_LT(sure.alpha(x, 0), 0.5f * alpha + 1e-3f) << x;
    }
    if (alpha > 0.98f) {
      EXPECT_GT(sure.alpha(x, 0), 0.5f * alpha + 0.5f - 1e-3f) << x;
    }
    if (alpha > 0.3f && alpha < 0.7f) {
      EXPECT_NEAR(sure.alpha(x, 0), alpha, 1e-3f) << x;
    }
  }
}

TEST(EstimateAlpha, TakesAnyWidth) {
  for (const int width : {1, 63, 64, 65, 130}) {
    const Image<glm::vec3> leaf(width, 2, srgb_from_linear(kLeaf));
    const AlphaEstimate found = estimate(leaf, leaf_and_sky(), 0.0f);
    ASSERT_EQ(found.alpha.width(), width);
    for (const float alpha : found.alpha.pixels()) EXPECT_GT(alpha, 0.97f);
  }
}

TEST(EstimateAlpha, FollowsThePlaceWhereColoursAgree) {
  const StrokeModel same{{cluster_of(kLeaf)}, {cluster_of(kLeaf)}};
  const Image<glm::vec3> leaf(8, 1, srgb_from_linear(kLeaf));
  EXPECT_NEAR(estimate(leaf, same, 0.0f).alpha(3, 0), 0.5f, 0.2f);
  EXPECT_GT(estimate(leaf, same, 6.0f).alpha(3, 0), 0.97f);
  EXPECT_LT(estimate(leaf, same, -6.0f).alpha(3, 0), 0.03f);
}

TEST(EstimateAlpha, TakesTheColourOfTheNearerStroke) {
  // Two backgrounds: a leaf-coloured one whose strokes are far, a sky-coloured one close by
  StrokeModel model = leaf_and_sky();
  model.background.push_back(cluster_of(kLeaf));
  model.background[1].squared_distance = Image<float>(4, 4, 0.5f);
  const Image<glm::vec3> leaf(8, 1, srgb_from_linear(kLeaf));
  EXPECT_GT(estimate(leaf, model, 0.0f).alpha(3, 0), 0.95f);
}

TEST(EstimateAlpha, TellsWhatNoColourExplains) {
  const Image<glm::vec3> red(8, 1, glm::vec3(0.9f, 0.05f, 0.05f)),
      leaf(8, 1, srgb_from_linear(kLeaf));
  EXPECT_LT(estimate(red, leaf_and_sky(), 0.0f).likelihood(0, 0),
            estimate(leaf, leaf_and_sky(), 0.0f).likelihood(0, 0) - 20.0f);
}

TEST(EstimateAlpha, StaysBetweenZeroAndOneForAllColoursAndSpaces) {
  Image<glm::vec3> colours(125, 1);
  for (int i = 0; i < 125; ++i) colours(i, 0) = glm::vec3(i % 5, i / 5 % 5, i / 25) / 4.0f;
  for (const char* mixing : {"curve", "lab", "srgb"}) {
    const AlphaEstimate found = estimate(colours, leaf_and_sky(), 0.0f, {mixing, 0.1f, 0.0f});
    for (const float alpha : found.alpha.pixels()) {
      ASSERT_TRUE(alpha >= 0.0f && alpha <= 1.0f) << mixing;  // false for NaN too
    }
  }
}

TEST(EstimateAlpha, StaysBetweenZeroAndOneWhateverItIsGiven) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                  kInfinity = std::numeric_limits<float>::infinity();
  for (const float strange : {kNan, kInfinity, -kInfinity, 1e30f, -1e30f}) {
    Image<float> plane(5, 1, 50.0f), tilt(5, 1, 0.0f);
    plane(1, 0) = strange;
    tilt(4, 0) = strange;
    StrokeModel model = leaf_and_sky();
    model.background[0].squared_distance(0, 0) = strange;
    Progress progress;
    const AlphaEstimate found = estimate_alpha({plane, plane, plane}, model, tilt, {}, progress);
    for (int x = 0; x < 5; ++x) {
      ASSERT_TRUE(found.alpha(x, 0) >= 0.0f && found.alpha(x, 0) <= 1.0f) << strange << ", " << x;
      ASSERT_TRUE(std::isfinite(found.likelihood(x, 0))) << strange << ", " << x;
    }
  }
}

}  // namespace
}  // namespace bosk
