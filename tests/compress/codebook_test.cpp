#include "core/compress/codebook.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <vector>

#include "core/base/random.h"

namespace bosk {
namespace {

VectorSet gaussian_vectors(std::size_t count, std::size_t groups, std::size_t channels) {
  Random random(5);
  VectorSet vectors{groups, channels, {}, {}};
  for (std::size_t i = 0; i < count * groups * channels; ++i) {
    vectors.values.push_back(float(random.normal()));
  }
  for (std::size_t i = 0; i < count * groups; ++i) {
    vectors.weights.push_back(float(random.uniform(0.1, 1.0)));
  }
  return vectors;
}

VectorSet scalars(std::vector<float> values) {
  const std::size_t count = values.size();
  return {1, 1, std::move(values), std::vector<float>(count, 1.0f)};
}

TEST(TrainCodebook, IsExactWhenFewerVectorsDiffer) {
  VectorSet vectors = gaussian_vectors(40, 1, 5);
  const std::vector<float> once = vectors.values;
  vectors.values.insert(vectors.values.end(), once.begin(), once.end());
  vectors.weights.resize(80, 1.0f);
  Progress quiet;
  const Codebook codebook = train_codebook(vectors, {.codewords = 64}, quiet);
  EXPECT_EQ(codebook.size(), 40u);
  EXPECT_EQ(codebook.error, 0.0);
  const auto indices = encode(vectors, search_table(codebook), quiet);
  for (std::size_t i = 0; i < 80; ++i) {
    const auto codeword = std::span(codebook.values).subspan(std::size_t(indices[i]) * 5, 5);
    EXPECT_EQ(distance(vectors, i, codeword), 0.0);
  }
}

TEST(TrainCodebook, FindsTheMeansOfTwoFarClusters) {
  const VectorSet vectors = scalars({-10.5f, -10.0f, -9.5f, 7.0f, 9.0f});
  Progress quiet;
  Codebook codebook = train_codebook(vectors, {.codewords = 2}, quiet);
  std::sort(codebook.values.begin(), codebook.values.end());
  ASSERT_EQ(codebook.size(), 2u);
  EXPECT_FLOAT_EQ(codebook.values[0], -10.0f);
  EXPECT_FLOAT_EQ(codebook.values[1], 8.0f);
  EXPECT_NEAR(codebook.error, (0.25 + 0.25 + 1.0 + 1.0) / 5.0,
              1e-9);  // exact but for the last bits
}

TEST(TrainCodebook, OfOneCodewordIsTheWeightedMean) {
  VectorSet vectors = scalars({0.0f, 10.0f});
  vectors.weights = {3.0f, 1.0f};
  Progress quiet;
  const Codebook codebook = train_codebook(vectors, {.codewords = 1}, quiet);
  ASSERT_EQ(codebook.size(), 1u);
  EXPECT_FLOAT_EQ(codebook.values[0], 2.5f);
}

TEST(TrainCodebook, TakesASingleVector) {
  Progress quiet;
  const Codebook codebook = train_codebook(scalars({4.0f}), {.codewords = 8}, quiet);
  ASSERT_EQ(codebook.size(), 1u);
  EXPECT_EQ(codebook.values[0], 4.0f);
  EXPECT_EQ(codebook.error, 0.0);
}

TEST(TrainCodebook, IgnoresValuesWithoutWeight) {
  VectorSet vectors{2, 1, {1.0f, 500.0f, 1.0f, -300.0f, 1.0f, 7.0f}, {1, 0, 1, 0, 1, 1}};
  Progress quiet;
  const Codebook codebook = train_codebook(vectors, {.codewords = 1}, quiet);
  EXPECT_FLOAT_EQ(codebook.values[0], 1.0f);
  EXPECT_FLOAT_EQ(codebook.values[1], 7.0f);
  EXPECT_EQ(codebook.error, 0.0);
}

// Two equal codewords: the second one never wins, so its cluster is empty.
TEST(RefineCodebook, MovesAnEmptyCodewordIntoTheWorstCluster) {
  const VectorSet vectors = scalars({0.0f, 1.0f, 100.0f, 120.0f});
  Progress quiet;
  Codebook codebook = refine_codebook(vectors, {0.5f, 110.0f, 110.0f}, {.codewords = 3}, quiet);
  std::sort(codebook.values.begin(), codebook.values.end());
  EXPECT_EQ(codebook.values, (std::vector{0.5f, 100.0f, 120.0f}));
}

TEST(RefineCodebook, LeavesAnEmptyCodewordWhereNothingCanBeSplit) {
  const VectorSet vectors = scalars({1.0f, 1.0f, 2.0f});
  Progress quiet;
  const Codebook codebook = refine_codebook(vectors, {1.0f, 2.0f, 2.0f}, {.codewords = 3}, quiet);
  EXPECT_EQ(codebook.error, 0.0);
  EXPECT_EQ(codebook.values, (std::vector{1.0f, 2.0f, 2.0f}));
}

// The error that the last round reports is after its move, so that it can only fall with more
// rounds.
TEST(RefineCodebook, NeverRaisesTheError) {
  const VectorSet vectors = gaussian_vectors(3000, 4, 3);
  Progress quiet;
  double previous = 1e300;
  for (const int rounds : {1, 2, 4, 8, 16}) {
    const Codebook codebook = train_codebook(
        vectors, {.codewords = 50, .max_rounds = rounds, .stop_improvement = 0.0}, quiet);
    EXPECT_LE(codebook.error, previous);
    previous = codebook.error;
  }
}

// Gaussian vectors have no clusters to find: here the usual start, codewords picked from the
// vectors, is at its best, and errors after training differ by less than 1% between starts.
TEST(TrainCodebook, IsAsGoodAsFromPickedVectorsWhereNothingClusters) {
  const VectorSet vectors = gaussian_vectors(20000, 1, 8);
  Progress quiet;
  const TrainingOptions options{.codewords = 256};
  const Codebook seeded = train_codebook(vectors, options, quiet);
  const std::vector<float> picked(vectors.values.begin(),
                                  vectors.values.begin() + std::ptrdiff_t(256) * 8);
  const Codebook random = refine_codebook(vectors, picked, options, quiet);
  EXPECT_LT(seeded.error, 1.01 * random.error);
}

TEST(TrainCodebook, SameWithOneThreadAndMany) {
  const VectorSet vectors = gaussian_vectors(5000, 16, 3);
  Progress quiet;
  const Codebook many = train_codebook(vectors, {.codewords = 100}, quiet);
  const auto many_indices = encode(vectors, search_table(many), quiet);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Codebook one = train_codebook(vectors, {.codewords = 100}, quiet);
  EXPECT_EQ(one.values, many.values);
  EXPECT_EQ(one.error, many.error);
  EXPECT_EQ(encode(vectors, search_table(one), quiet), many_indices);
}

TEST(TrainCodebook, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(train_codebook(gaussian_vectors(100, 1, 4), {.codewords = 10}, progress), Cancelled);
}

// The weighted distance is what the search minimises: checked against the definition.
TEST(Encode, FindsTheNearestByWeightedDistance) {
  const VectorSet vectors = gaussian_vectors(500, 16, 3);
  Progress quiet;
  const Codebook codebook = train_codebook(vectors, {.codewords = 40}, quiet);
  const auto indices = encode(vectors, search_table(codebook), quiet);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    double best = 1e300, chosen = 0.0;
    for (std::size_t k = 0; k < codebook.size(); ++k) {
      const double d = distance(vectors, i, std::span(codebook.values).subspan(k * 48, 48));
      best = std::min(best, d);
      if (k == indices[i]) chosen = d;
    }
    EXPECT_LE(chosen, best + 1e-4);  // float sums of 64 terms of size 1
  }
}

TEST(GroupByCodeword, ListsMembersInOrder) {
  const std::vector<std::uint16_t> indices{2, 0, 2, 2};
  const Clusters clusters = group_by_codeword(indices, 3);
  EXPECT_EQ(clusters.first, (std::vector<std::uint32_t>{0, 1, 1, 4}));
  EXPECT_EQ(clusters.vectors, (std::vector<std::uint32_t>{1, 0, 2, 3}));
}

}  // namespace
}  // namespace bosk
