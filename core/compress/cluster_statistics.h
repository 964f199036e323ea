#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/compress/vector_set.h"

namespace bosk {

// Weighted mean and spread of some vectors of a set. Where no vector has weight in a group, its
// mean is that of the values given (a fill), so that no coordinate is left undefined.
struct ClusterStatistics {
  std::vector<double> mean;
  double error = 0.0;      // sum of distances to the mean
  std::size_t widest = 0;  // the coordinate that adds most to the error
};
ClusterStatistics cluster_statistics(const VectorSet& vectors,
                                     std::span<const std::uint32_t> members);

}  // namespace bosk
