#include "core/matte/clusters.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace bosk {
namespace {

constexpr int kRounds = 24;

float squared(const glm::vec3& v) { return glm::dot(v, v); }

// Each further centre is the sample furthest from those chosen, damped by drawing it among the
// samples in proportion to squared distance (k-means++, Arthur and Vassilvitskii 2007), from a
// fixed sequence.
std::vector<glm::vec3> first_centres(const std::vector<glm::vec3>& lab, int wanted) {
  std::vector<glm::vec3> centres{lab[lab.size() / 2]};
  std::vector<float> nearest(lab.size(), std::numeric_limits<float>::max());
  std::uint32_t state = 12345;
  while (int(centres.size()) < wanted) {
    double total = 0.0;
    for (std::size_t i = 0; i < lab.size(); ++i) {
      nearest[i] = std::min(nearest[i], squared(lab[i] - centres.back()));
      total += nearest[i];
    }
    if (total <= 0.0) break;
    state = state * 1664525u + 1013904223u;
    double left = total * (double(state >> 8) / double(1u << 24));
    std::size_t pick = 0;
    while (pick + 1 < lab.size() && left >= nearest[pick]) left -= nearest[pick++];
    if (nearest[pick] <= 0.0f)
      pick = std::size_t(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    centres.push_back(lab[pick]);
  }
  return centres;
}

int nearest_centre(const std::vector<glm::vec3>& centres, const glm::vec3& colour) {
  int best = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t c = 0; c < centres.size(); ++c) {
    const float distance = squared(colour - centres[c]);
    if (distance < least) {
      least = distance;
      best = int(c);
    }
  }
  return best;
}

// Moves each centre to the mean of its samples; true while any sample changes its cluster.
bool lloyd_round(const std::vector<glm::vec3>& lab, std::vector<glm::vec3>& centres,
                 std::vector<int>& of) {
  bool changed = false;
  std::vector<glm::dvec3> sum(centres.size(), glm::dvec3(0.0));
  std::vector<int> count(centres.size(), 0);
  for (std::size_t i = 0; i < lab.size(); ++i) {
    const int c = nearest_centre(centres, lab[i]);
    changed = changed || c != of[i];
    of[i] = c;
    sum[std::size_t(c)] += lab[i];
    ++count[std::size_t(c)];
  }
  for (std::size_t c = 0; c < centres.size(); ++c) {
    if (count[c] > 0) centres[c] = glm::vec3(sum[c] / double(count[c]));
  }
  return changed;
}

// Drops empty clusters and measures the spread of the others.
Clustering summarise(const std::vector<glm::vec3>& lab, const std::vector<int>& of,
                     std::size_t count, float least_variance) {
  std::vector<glm::dvec3> sum(count, glm::dvec3(0.0));
  std::vector<std::array<double, 6>> square(count);
  std::vector<int> members(count, 0), new_index(count, -1);
  for (std::size_t i = 0; i < lab.size(); ++i) {
    const auto c = std::size_t(of[i]);
    const glm::dvec3 v = lab[i];
    sum[c] += v;
    const std::array<double, 6> products{v.x * v.x, v.y * v.x, v.y * v.y,
                                         v.z * v.x, v.z * v.y, v.z * v.z};
    for (std::size_t k = 0; k < 6; ++k) square[c][k] += products[k];
    ++members[c];
  }
  Clustering result;
  for (std::size_t c = 0; c < count; ++c) {
    if (members[c] == 0) continue;
    const glm::dvec3 m = sum[c] / double(members[c]);
    const std::array<double, 6> mean_products{m.x * m.x, m.y * m.x, m.y * m.y,
                                              m.z * m.x, m.z * m.y, m.z * m.z};
    ColourCluster cluster;
    cluster.lab = glm::vec3(m);
    for (std::size_t k = 0; k < 6; ++k)
      cluster.covariance[k] = float(square[c][k] / members[c] - mean_products[k]);
    cluster.variance =
        std::max((cluster.covariance[0] + cluster.covariance[2] + cluster.covariance[5]) / 3.0f,
                 least_variance);
    for (const std::size_t k : {0u, 2u, 5u}) cluster.covariance[k] += least_variance;
    cluster.share = float(members[c]) / float(lab.size());
    new_index[c] = int(result.clusters.size());
    result.clusters.push_back(cluster);
  }
  for (const int c : of) result.cluster_of_sample.push_back(new_index[std::size_t(c)]);
  return result;
}

}  // namespace

Clustering cluster_colours(const std::vector<glm::vec3>& lab, int wanted, float least_variance) {
  if (lab.empty()) return {};
  std::vector<glm::vec3> centres = first_centres(lab, wanted);
  std::vector<int> of(lab.size(), -1);
  for (int round = 0; round < kRounds && lloyd_round(lab, centres, of); ++round) {
  }
  return summarise(lab, of, centres.size(), least_variance);
}

}  // namespace bosk
