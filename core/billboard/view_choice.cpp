#include "core/billboard/view_choice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace bosk {
namespace {

constexpr double kLowest = -0.05;  // sine of the lowest view's elevation
constexpr double kGoldenAngle = std::numbers::pi * (3.0 - 2.23606797749979);

double median_distance(const std::vector<Camera>& cameras, const Box& crown) {
  std::vector<double> distances;
  distances.reserve(cameras.size());
  for (const Camera& camera : cameras) {
    distances.push_back(glm::length(camera.centre_in_world() - crown.centre()));
  }
  if (distances.empty()) return 2.0 * glm::length(crown.size());
  const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace

std::vector<glm::dvec3> hemisphere_views(const std::vector<Camera>& cameras, const Box& crown,
                                         int count) {
  assert(count > 0);
  const double distance = median_distance(cameras, crown);
  std::vector<glm::dvec3> views;
  for (int i = 0; i < count; ++i) {
    const double height = kLowest + (1.0 - kLowest) * (i + 0.5) / count;
    const double across = std::sqrt(1.0 - height * height);
    const double turn = kGoldenAngle * i;
    views.push_back(crown.centre() + distance * glm::dvec3(across * std::cos(turn),
                                                           across * std::sin(turn), height));
  }
  return views;
}

}  // namespace bosk
