#include "core/compress/cluster_statistics.h"

#include <algorithm>

namespace bosk {
namespace {

// The weight of each coordinate.
void spread_weights(const VectorSet& vectors, std::size_t vector, float* weights) {
  for (const float weight : vectors.weight_row(vector)) {
    weights = std::fill_n(weights, vectors.channels, weight);
  }
}

// Sums of w, w x and w x^2 about a vector of the cluster, which keeps the differences well
// conditioned.
struct Moments {
  std::vector<double> weight, first, second;
};

Moments moments_about(const VectorSet& vectors, std::span<const std::uint32_t> members,
                      std::span<const float> pivot) {
  const std::size_t dimension = vectors.dimension();
  Moments moments{std::vector<double>(dimension), std::vector<double>(dimension),
                  std::vector<double>(dimension)};
  std::vector<float> weights(dimension);
  double* weight_sum = moments.weight.data();
  double* first = moments.first.data();
  double* second = moments.second.data();
  for (const std::uint32_t member : members) {
    spread_weights(vectors, member, weights.data());
    const float* values = vectors.value_row(member).data();
    for (std::size_t d = 0; d < dimension; ++d) {
      const double weight = double(weights[d]);
      const double offset = double(values[d] - pivot[d]);
      weight_sum[d] += weight;
      first[d] += weight * offset;
      second[d] += weight * offset * offset;
    }
  }
  return moments;
}

double plain_mean(const VectorSet& vectors, std::span<const std::uint32_t> members, std::size_t d) {
  double sum = 0.0;
  for (const std::uint32_t member : members) sum += double(vectors.value_row(member)[d]);
  return sum / double(members.size());
}

}  // namespace

ClusterStatistics cluster_statistics(const VectorSet& vectors,
                                     std::span<const std::uint32_t> members) {
  const auto pivot = vectors.value_row(members.front());
  const Moments moments = moments_about(vectors, members, pivot);
  ClusterStatistics result;
  result.mean.resize(vectors.dimension());
  double widest_error = 0.0;
  for (std::size_t d = 0; d < vectors.dimension(); ++d) {
    const double weight = moments.weight[d];
    if (weight <= 0.0) {
      result.mean[d] = plain_mean(vectors, members, d);
      continue;
    }
    const double offset = moments.first[d] / weight;
    const double error = std::max(0.0, moments.second[d] - moments.first[d] * offset);
    result.mean[d] = double(pivot[d]) + offset;
    result.error += error;
    if (error > widest_error) result.widest = d;
    widest_error = std::max(widest_error, error);
  }
  return result;
}

}  // namespace bosk
