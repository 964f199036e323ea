#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bosk {

// One step of the search's table: the same coordinate of 32 codewords side by side.
struct alignas(64) CodewordLanes {
  std::array<float, 32> lane{};
};

// Codewords laid out for the search, 32 at a time: [panel][bias, coordinate 0, 1, ...][lane]. A
// last panel that isn't full repeats the last codeword, which never wins because ties go to the
// lower index.
struct CodewordTable {
  int dimension = 0;
  std::size_t count = 0;
  std::vector<CodewordLanes> lanes;
};

// `codewords` holds count x dimension coordinates, `biases` one number per codeword; at least one
// and at most 65535 codewords.
CodewordTable make_codeword_table(std::span<const float> codewords, std::span<const float> biases,
                                  int dimension);

// Which machine instructions the search uses; all give the same index unless two codewords' scores
// differ by rounding alone.
enum class InstructionSet { baseline, avx2, avx512 };
InstructionSet widest_instruction_set();  // that this processor has

// For each query (dimension coordinates, one after another) the codeword with the smallest
// bias - query . codeword; ties go to the lower index. With bias = |codeword|^2 / 2 this is the
// codeword at the smallest Euclidean distance. Runs in the calling thread.
void nearest_codewords(const CodewordTable& table, std::span<const float> queries,
                       std::span<std::uint16_t> indices, InstructionSet instructions);
void nearest_codewords(const CodewordTable& table, std::span<const float> queries,
                       std::span<std::uint16_t> indices);

}  // namespace bosk
