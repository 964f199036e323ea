#include <algorithm>
#include <numeric>
#include <queue>

#include "core/compress/cluster_statistics.h"
#include "core/compress/codebook.h"

namespace bosk {
namespace {

struct Part {
  std::size_t first = 0, last = 0;  // members, in the order being partitioned
  ClusterStatistics statistics;
};

struct SmallerError {
  bool operator()(const Part& a, const Part& b) const {
    if (a.statistics.error != b.statistics.error) return a.statistics.error < b.statistics.error;
    return a.first > b.first;
  }
};
using Parts = std::priority_queue<Part, std::vector<Part>, SmallerError>;

Part make_part(const VectorSet& vectors, const std::vector<std::uint32_t>& order, std::size_t first,
               std::size_t last) {
  return {first, last, cluster_statistics(vectors, std::span(order).subspan(first, last - first))};
}

// Cuts at the mean of the widest coordinate; gives the first member of the upper part.
std::size_t cut(const VectorSet& vectors, const Part& part, std::vector<std::uint32_t>& order) {
  const std::size_t d = part.statistics.widest;
  const double mean = part.statistics.mean[d];
  const auto begin = order.begin();
  const auto middle = std::stable_partition(
      begin + std::ptrdiff_t(part.first), begin + std::ptrdiff_t(part.last),
      [&](std::uint32_t member) { return double(vectors.value_row(member)[d]) <= mean; });
  return std::size_t(middle - begin);
}

std::vector<float> means(Parts parts) {
  std::vector<float> codewords;
  for (; !parts.empty(); parts.pop()) {
    for (const double mean : parts.top().statistics.mean) codewords.push_back(float(mean));
  }
  return codewords;
}

}  // namespace

std::vector<float> seed_codewords(const VectorSet& vectors, std::size_t codewords,
                                  Progress& progress) {
  std::vector<std::uint32_t> order(vectors.size());
  std::iota(order.begin(), order.end(), 0u);
  Parts parts;
  parts.push(make_part(vectors, order, 0, order.size()));
  while (parts.size() < codewords && parts.top().statistics.error > 0.0) {
    progress.check();
    Part part = parts.top();
    parts.pop();
    const std::size_t middle = cut(vectors, part, order);
    if (middle == part.first || middle == part.last) {  // values that differ by rounding alone
      part.statistics.error = 0.0;
      parts.push(part);
      continue;
    }
    parts.push(make_part(vectors, order, part.first, middle));
    parts.push(make_part(vectors, order, middle, part.last));
  }
  return means(std::move(parts));
}

}  // namespace bosk
