#include "core/compress/codebook.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/compress/cluster_statistics.h"

namespace bosk {
namespace {

// The search minimises bias - query . codeword. With query (w x, w) and codeword (c, -|c|^2 / 2)
// per group that is sum w (|c|^2 / 2 - x . c): half the distance, but for what the vector alone
// adds.
void write_query(const VectorSet& vectors, std::size_t vector, float* query) {
  const float* value = vectors.value_row(vector).data();
  for (const float weight : vectors.weight_row(vector)) {
    for (std::size_t c = 0; c < vectors.channels; ++c) *query++ = weight * *value++;
  }
  std::ranges::copy(vectors.weight_row(vector), query);
}

std::vector<ClusterStatistics> all_statistics(const VectorSet& vectors, const Clusters& clusters,
                                              Progress& progress) {
  std::vector<ClusterStatistics> statistics(clusters.first.size() - 1);
  tbb::parallel_for(std::size_t(0), statistics.size(), [&](std::size_t codeword) {
    progress.check();
    const auto members = clusters.members(codeword);
    if (!members.empty()) statistics[codeword] = cluster_statistics(vectors, members);
  });
  return statistics;
}

void set_codeword(Codebook& codebook, std::size_t codeword, const std::vector<double>& mean) {
  std::transform(mean.begin(), mean.end(),
                 codebook.values.begin() + std::ptrdiff_t(codeword * codebook.dimension()),
                 [](double value) { return float(value); });
}

// Gives the cluster's lower half to its own codeword and the upper half to `empty`.
void split_cluster(const VectorSet& vectors, std::span<const std::uint32_t> members,
                   const ClusterStatistics& statistics, std::size_t codeword, std::size_t empty,
                   Codebook& codebook) {
  const std::size_t d = statistics.widest;
  std::vector<std::uint32_t> halves(members.begin(), members.end());
  const auto middle =
      std::stable_partition(halves.begin(), halves.end(), [&](std::uint32_t member) {
        return double(vectors.value_row(member)[d]) <= statistics.mean[d];
      });
  if (middle == halves.begin() || middle == halves.end()) return;
  set_codeword(codebook, codeword, cluster_statistics(vectors, {halves.begin(), middle}).mean);
  set_codeword(codebook, empty, cluster_statistics(vectors, {middle, halves.end()}).mean);
}

// Moves each codeword without members into the worst cluster that no other moved into. True if any
// did.
bool repair_empty(const VectorSet& vectors, const Clusters& clusters,
                  const std::vector<ClusterStatistics>& statistics, Codebook& codebook) {
  std::vector<std::size_t> empty, worst;
  for (std::size_t codeword = 0; codeword < statistics.size(); ++codeword) {
    if (clusters.members(codeword).empty()) empty.push_back(codeword);
    if (statistics[codeword].error > 0.0) worst.push_back(codeword);
  }
  std::stable_sort(worst.begin(), worst.end(), [&](std::size_t a, std::size_t b) {
    return statistics[a].error > statistics[b].error;
  });
  const std::size_t repaired = std::min(empty.size(), worst.size());
  for (std::size_t i = 0; i < repaired; ++i) {
    const std::size_t codeword = worst[i];
    split_cluster(vectors, clusters.members(codeword), statistics[codeword], codeword, empty[i],
                  codebook);
  }
  return repaired > 0;
}

struct LloydRound {
  double error = 0.0;  // sum of distances to the moved codewords
  bool repaired = false;
};

// Assigns every vector and moves each codeword to the mean of its vectors.
LloydRound lloyd_round(const VectorSet& vectors, Codebook& codebook, Progress& progress) {
  const auto indices = encode(vectors, search_table(codebook), progress);
  const Clusters clusters = group_by_codeword(indices, codebook.size());
  const auto statistics = all_statistics(vectors, clusters, progress);
  LloydRound round;
  for (std::size_t codeword = 0; codeword < statistics.size(); ++codeword) {
    if (clusters.members(codeword).empty()) continue;
    set_codeword(codebook, codeword, statistics[codeword].mean);
    round.error += statistics[codeword].error;
  }
  round.repaired = repair_empty(vectors, clusters, statistics, codebook);
  return round;
}

}  // namespace

CodewordTable search_table(const Codebook& codebook) {
  const std::size_t dimension = codebook.dimension() + codebook.groups;
  std::vector<float> rows;
  rows.reserve(codebook.size() * dimension);
  for (std::size_t codeword = 0; codeword < codebook.size(); ++codeword) {
    const float* values = codebook.values.data() + codeword * codebook.dimension();
    rows.insert(rows.end(), values, values + codebook.dimension());
    for (std::size_t group = 0; group < codebook.groups; ++group) {
      double square = 0.0;
      for (std::size_t c = 0; c < codebook.channels; ++c) {
        square += double(values[group * codebook.channels + c]) *
                  double(values[group * codebook.channels + c]);
      }
      rows.push_back(float(-0.5 * square));
    }
  }
  const std::vector<float> biases(codebook.size(), 0.0f);
  return make_codeword_table(rows, biases, int(dimension));
}

void encode(const VectorSet& vectors, const CodewordTable& table, std::size_t first,
            std::span<std::uint16_t> indices) {
  const auto dimension = std::size_t(table.dimension);
  std::vector<float> queries(indices.size() * dimension);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    write_query(vectors, first + i, queries.data() + i * dimension);
  }
  nearest_codewords(table, queries, indices);
}

std::vector<std::uint16_t> encode(const VectorSet& vectors, const CodewordTable& table,
                                  Progress& progress) {
  std::vector<std::uint16_t> indices(vectors.size());
  const std::size_t chunks = (vectors.size() + kEncodeChunk - 1) / kEncodeChunk;
  tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
    progress.check();
    const std::size_t first = chunk * kEncodeChunk;
    const std::size_t count = std::min(kEncodeChunk, vectors.size() - first);
    encode(vectors, table, first, std::span(indices).subspan(first, count));
  });
  return indices;
}

double distance(const VectorSet& vectors, std::size_t vector, std::span<const float> codeword) {
  const auto values = vectors.value_row(vector);
  const auto weights = vectors.weight_row(vector);
  double sum = 0.0;
  for (std::size_t d = 0; d < values.size(); ++d) {
    const double difference = double(values[d]) - double(codeword[d]);
    sum += double(weights[d / vectors.channels]) * difference * difference;
  }
  return sum;
}

Clusters group_by_codeword(std::span<const std::uint16_t> indices, std::size_t codewords) {
  Clusters clusters{std::vector<std::uint32_t>(codewords + 1),
                    std::vector<std::uint32_t>(indices.size())};
  for (const std::uint16_t index : indices) ++clusters.first[index + 1u];
  for (std::size_t k = 0; k < codewords; ++k) clusters.first[k + 1] += clusters.first[k];
  std::vector<std::uint32_t> next = clusters.first;
  for (std::uint32_t vector = 0; vector < indices.size(); ++vector) {
    clusters.vectors[next[indices[vector]]++] = vector;
  }
  return clusters;
}

Codebook refine_codebook(const VectorSet& vectors, std::vector<float> codewords,
                         const TrainingOptions& options, Progress& progress) {
  Codebook codebook{vectors.groups, vectors.channels, std::move(codewords), 0, 0.0};
  double weight = 0.0;
  for (const float w : vectors.weights) weight += double(w);
  double previous = std::numeric_limits<double>::max();
  while (codebook.rounds < options.max_rounds) {
    const LloydRound round = lloyd_round(vectors, codebook, progress);
    ++codebook.rounds;
    codebook.error = weight > 0.0 ? round.error / weight : 0.0;
    progress.advance();
    const bool settled = previous - round.error <= options.stop_improvement * previous;
    if (settled && !round.repaired) break;
    previous = round.error;
  }
  return codebook;
}

Codebook train_codebook(const VectorSet& vectors, const TrainingOptions& options,
                        Progress& progress) {
  assert(vectors.size() > 0 && options.codewords > 0);
  return refine_codebook(vectors, seed_codewords(vectors, std::size_t(options.codewords), progress),
                         options, progress);
}

}  // namespace bosk
