#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace bosk {

// A ball of similar colours in CIELab.
struct ColourCluster {
  glm::vec3 lab{0.0f};
  float variance = 0.0f;              // per axis
  std::array<float, 6> covariance{};  // lower triangle: xx, yx yy, zx zy zz
  float share = 0.0f;                 // of all samples
};

struct Clustering {
  std::vector<ColourCluster> clusters;  // at most as many as wanted, none empty
  std::vector<int> cluster_of_sample;
};

// k-means with a fixed seed: the same samples give the same clusters. Fewer clusters come back when
// there are fewer distinct colours. `least_variance` keeps a flat colour from being infinitely
// sharp.
Clustering cluster_colours(const std::vector<glm::vec3>& lab, int wanted, float least_variance);

}  // namespace bosk
