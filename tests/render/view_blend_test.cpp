#include "core/render/view_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/render/toy_trees.h"

namespace bosk {
namespace {

constexpr double kPi = std::numbers::pi;

TreeModel with_views(std::vector<glm::dvec3> positions) {
  TreeModel model = toy::one_billboard();
  const auto count = std::uint32_t(positions.size());
  model.view_positions = std::move(positions);
  model.levels = {
      toy::make_level(0, 4, 1.0f, {0}, count, [](auto...) { return std::uint16_t(0); })};
  return model;
}

std::vector<float> weights(const ViewPicker& picker, const glm::dvec3& eye) {
  std::vector<float> result(picker.view_count(), 0.0f);
  const ViewBlend blend = picker.pick({0, 0, 1}, eye);
  result[blend.a] += 1.0f - blend.weight_b;
  result[blend.b] += blend.weight_b;
  return result;
}

float largest_change(const std::vector<float>& before, const std::vector<float>& after) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < before.size(); ++i)
    largest = std::max(largest, std::abs(after[i] - before[i]));
  return largest;
}

glm::dvec3 on_sphere(double azimuth, double elevation) {
  return glm::dvec3(0, 0, 1) + 8.0 * glm::dvec3(std::cos(azimuth) * std::cos(elevation),
                                                std::sin(azimuth) * std::cos(elevation),
                                                std::sin(elevation));
}

TEST(ViewPicker, FindsTheTwoViewsNearestInAngle) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<glm::dvec3> positions;
  positions.reserve(150);
  for (int i = 0; i < 150; ++i)
    positions.push_back(5.0 * glm::dvec3(normal(random), normal(random), normal(random)));
  const TreeModel model = with_views(positions);
  const ViewPicker picker(model, model.levels[0], BlendRule::linear);
  for (int trial = 0; trial < 200; ++trial) {
    const glm::dvec3 centre(normal(random), normal(random), normal(random));
    const glm::dvec3 eye = 9.0 * glm::dvec3(normal(random), normal(random), normal(random));
    std::vector<std::pair<double, std::uint32_t>> angles;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
      angles.emplace_back(
          std::acos(glm::dot(glm::normalize(positions[i] - centre), glm::normalize(eye - centre))),
          i);
    std::sort(angles.begin(), angles.end());
    const ViewBlend blend = picker.pick(centre, eye);
    EXPECT_EQ(blend.a, angles[0].second);
    EXPECT_EQ(blend.b, angles[1].second);
    EXPECT_NEAR(blend.weight_b, angles[0].first / (angles[0].first + angles[1].first), 1e-5);
  }
}

TEST(ViewPicker, GivesOneViewAllTheWeightWhereItWasBaked) {
  const TreeModel model = with_views(toy::ring(12, 6, 1));
  for (const BlendRule rule : {BlendRule::linear, BlendRule::fading}) {
    const ViewPicker picker(model, model.levels[0], rule);
    for (std::uint32_t view = 0; view < 12; ++view) {
      const ViewBlend blend = picker.pick({0, 0, 1}, model.view_positions[view]);
      EXPECT_EQ(blend.a, view);
      EXPECT_LT(blend.weight_b, 1e-6f);
    }
  }
}

TEST(ViewPicker, GivesASingleViewAllTheWeightAndReportsNone) {
  const TreeModel one = with_views({{3, 4, 5}});
  const ViewBlend blend =
      ViewPicker(one, one.levels[0], BlendRule::fading).pick({0, 0, 1}, {9, 0, 0});
  EXPECT_EQ(blend.a, 0u);
  EXPECT_EQ(blend.b, 0u);
  EXPECT_EQ(blend.weight_b, 0.0f);
  const TreeModel none = with_views({});
  const ViewPicker picker(none, none.levels[0], BlendRule::fading);
  EXPECT_EQ(picker.pick({0, 0, 1}, {9, 0, 0}).a, picker.view_count());
}

TEST(ViewPicker, LinearRuleIsContinuousInTheRingOfTheViews) {
  const TreeModel model = with_views(toy::ring(12, 8, 1));
  const ViewPicker picker(model, model.levels[0], BlendRule::linear);
  std::vector<float> before = weights(picker, on_sphere(0, 0));
  for (int step = 1; step <= 7200; ++step) {
    const std::vector<float> after = weights(picker, on_sphere(step * kPi / 3600, 0));
    // 1/20 degree of 30 between views moves the weight by 1/600
    ASSERT_LT(largest_change(before, after), 1.1f / 600.0f) << step;
    before = after;
  }
}

TEST(ViewPicker, FadingRuleIsContinuousAboveTheRingWhereTheLinearOneJumps) {
  const TreeModel model = with_views(toy::ring(12, 8, 1));
  const ViewPicker fading(model, model.levels[0], BlendRule::fading);
  const ViewPicker linear(model, model.levels[0], BlendRule::linear);
  for (const double elevation : {0.0, 0.3, 0.8}) {
    float fading_jump = 0.0f, linear_jump = 0.0f;
    for (int step = 1; step <= 7200; ++step) {
      const glm::dvec3 here = on_sphere((step - 1) * kPi / 3600, elevation);
      const glm::dvec3 there = on_sphere(step * kPi / 3600, elevation);
      fading_jump =
          std::max(fading_jump, largest_change(weights(fading, here), weights(fading, there)));
      linear_jump =
          std::max(linear_jump, largest_change(weights(linear, here), weights(linear, there)));
    }
    EXPECT_LT(fading_jump, 0.01f) << elevation;  // the steepest slope is twice the linear rule's
    EXPECT_TRUE(elevation < 0.1 || linear_jump > 0.3f) << elevation << ' ' << linear_jump;
  }
}

TEST(ViewPicker, GivesFiniteWeightsWhenTheEyeIsAtTheCentreOrAView) {
  const TreeModel model = with_views({{0, 0, 1}, {0, 0, 1}, {5, 0, 1}});
  for (const BlendRule rule : {BlendRule::linear, BlendRule::fading}) {
    const ViewPicker picker(model, model.levels[0], rule);
    for (const glm::dvec3 eye : {glm::dvec3(0, 0, 1), glm::dvec3(5, 0, 1), glm::dvec3(-5, 0, 1)}) {
      const ViewBlend blend = picker.pick({0, 0, 1}, eye);
      EXPECT_TRUE(blend.weight_b >= 0.0f && blend.weight_b <= 1.0f);
    }
  }
}

}  // namespace
}  // namespace bosk
