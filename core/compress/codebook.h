#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/compress/nearest_codeword.h"
#include "core/compress/vector_set.h"

namespace bosk {

struct TrainingOptions {
  int codewords = 1024;            // 1 to 4096
  int max_rounds = 30;             // of the generalised Lloyd algorithm
  double stop_improvement = 1e-3;  // training ends when a round gains less, relative to the error
};

struct Codebook {
  std::size_t groups = 1, channels = 1;
  std::vector<float> values;  // codeword after codeword
  int rounds = 0;             // that training took
  double error = 0.0;  // distance of the training vectors to their codewords, a mean by weight

  std::size_t dimension() const { return groups * channels; }
  std::size_t size() const { return values.size() / dimension(); }
};

// Codewords for `vectors`, which count by their weights: seed_codewords, then refine_codebook.
// Gives fewer codewords than asked for when fewer vectors differ; the error is then zero. Without
// random numbers: the same result every time, at any thread count. Needs one vector or more.
Codebook train_codebook(const VectorSet& vectors, const TrainingOptions& options,
                        Progress& progress);

// Generalised Lloyd algorithm (Linz et al. 2006, section 4.1) from the codewords given: each moves
// to the mean of the vectors nearest to it, until the error settles. Differs from the paper: a
// codeword that no vector is nearest to takes half of the cluster with the largest error, if any
// has an error.
Codebook refine_codebook(const VectorSet& vectors, std::vector<float> codewords,
                         const TrainingOptions& options, Progress& progress);

// Seeds by divisive clustering (Su and Dy 2007, "Var-Part"): the cluster with the largest error is
// cut at its mean, across the coordinate that varies most, until there are enough. Needs one vector
// or more.
std::vector<float> seed_codewords(const VectorSet& vectors, std::size_t codewords,
                                  Progress& progress);

// For each vector its nearest codeword; ties go to the lower index.
CodewordTable search_table(const Codebook& codebook);
std::vector<std::uint16_t> encode(const VectorSet& vectors, const CodewordTable& table,
                                  Progress& progress);
// The same for vectors first, first + 1, ... alone, in the calling thread. Chunks of this size keep
// their queries in the second-level cache.
inline constexpr std::size_t kEncodeChunk = 768;
void encode(const VectorSet& vectors, const CodewordTable& table, std::size_t first,
            std::span<std::uint16_t> indices);

// Distance of one vector to one codeword, as VectorSet defines it.
double distance(const VectorSet& vectors, std::size_t vector, std::span<const float> codeword);

// Vectors grouped by codeword, each group in ascending order: members of codeword k are
// vectors[first[k]] .. vectors[first[k + 1] - 1].
struct Clusters {
  std::vector<std::uint32_t> first, vectors;

  std::span<const std::uint32_t> members(std::size_t codeword) const {
    return std::span(vectors).subspan(first[codeword], first[codeword + 1] - first[codeword]);
  }
};
Clusters group_by_codeword(std::span<const std::uint16_t> indices, std::size_t codewords);

}  // namespace bosk
