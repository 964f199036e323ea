#include "core/compress/nearest_codeword.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace bosk {
namespace {

std::vector<float> random_numbers(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> numbers(count);
  for (float& number : numbers) number = float(random.normal());
  return numbers;
}

std::vector<float> half_squares(const std::vector<float>& codewords, std::size_t dimension) {
  std::vector<float> halves(codewords.size() / dimension);
  for (std::size_t i = 0; i < codewords.size(); ++i) {
    halves[i / dimension] += 0.5f * codewords[i] * codewords[i];
  }
  return halves;
}

std::uint16_t nearest_by_definition(const float* query, const std::vector<float>& codewords,
                                    std::size_t dimension) {
  std::uint16_t best = 0;
  double best_square = 1e300;
  for (std::size_t k = 0; k < codewords.size() / dimension; ++k) {
    double square = 0.0;
    for (std::size_t d = 0; d < dimension; ++d) {
      const double difference = double(query[d]) - double(codewords[k * dimension + d]);
      square += difference * difference;
    }
    if (square < best_square) best = std::uint16_t(k);
    best_square = std::min(best_square, square);
  }
  return best;
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets{InstructionSet::baseline};
  if (widest_instruction_set() >= InstructionSet::avx2) sets.push_back(InstructionSet::avx2);
  if (widest_instruction_set() >= InstructionSet::avx512) sets.push_back(InstructionSet::avx512);
  return sets;
}

// Gaussian vectors: the smallest two distances of 300 queries differ by far more than rounding
// does.
TEST(NearestCodeword, IsTheDefinitionsOnEveryInstructionSet) {
  for (const std::size_t dimension : {3u, 16u, 48u, 68u}) {
    for (const std::size_t count : {1u, 2u, 31u, 32u, 33u, 500u}) {
      const auto codewords = random_numbers(count * dimension, 1);
      const auto queries = random_numbers(301 * dimension, 2);
      const CodewordTable table =
          make_codeword_table(codewords, half_squares(codewords, dimension), int(dimension));
      for (const InstructionSet instructions : instruction_sets()) {
        std::vector<std::uint16_t> indices(301);
        nearest_codewords(table, queries, indices, instructions);
        for (std::size_t i = 0; i < indices.size(); ++i) {
          ASSERT_EQ(indices[i],
                    nearest_by_definition(queries.data() + i * dimension, codewords, dimension))
              << "dimension " << dimension << ", codewords " << count << ", query " << i;
        }
      }
    }
  }
}

TEST(NearestCodeword, GivesTiesToTheLowerIndex) {
  const std::size_t dimension = 16, repeats = 100;
  const auto one = random_numbers(dimension, 3);
  std::vector<float> codewords;
  for (std::size_t i = 0; i < repeats; ++i) {
    codewords.insert(codewords.end(), one.begin(), one.end());
  }
  for (std::size_t d = 0; d < 7 * dimension; ++d)
    codewords[d] += 5.0f;  // the first 7 lie elsewhere
  const CodewordTable table =
      make_codeword_table(codewords, half_squares(codewords, dimension), int(dimension));
  for (const InstructionSet instructions : instruction_sets()) {
    std::vector<std::uint16_t> indices(1);
    nearest_codewords(table, one, indices, instructions);
    EXPECT_EQ(indices[0], 7);
  }
}

TEST(NearestCodeword, TakesNoQueriesForNoAnswer) {
  const std::vector<float> codeword{1.0f, 2.0f, 3.0f}, bias{0.0f};
  const CodewordTable table = make_codeword_table(codeword, bias, 3);
  std::vector<std::uint16_t> indices;
  nearest_codewords(table, {}, indices);
  EXPECT_TRUE(indices.empty());
}

}  // namespace
}  // namespace bosk
