#include "core/compress/cluster_statistics.h"

#include <algorithm>

namespace bosk {
namespace {

// Sums of w, w x and w x^2 about a vector of the cluster, which keeps the differences well
// conditioned.
struct Moments {
  std::vector<double> weight, first, second;
};

Moments moments_about(const VectorSet& vectors, std::span<const std::uint32_t> members,
                      std::span<const float> pivot) {
  const std::size_t channels = vectors.channels;
  Moments moments{std::vector<double>(vectors.groups), std::vector<double>(vectors.dimension()),
                  std::vector<double>(vectors.dimension())};
  for (const std::uint32_t member : members) {
    const auto values = vectors.value_row(member);
    const auto weights = vectors.weight_row(member);
    for (std::size_t group = 0; group < vectors.groups; ++group) {
      const double weight = double(weights[group]);
      moments.weight[group] += weight;
      for (std::size_t d = group * channels; d < (group + 1) * channels; ++d) {
        const double offset = double(values[d]) - double(pivot[d]);
        moments.first[d] += weight * offset;
        moments.second[d] += weight * offset * offset;
      }
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
    const double weight = moments.weight[d / vectors.channels];
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
