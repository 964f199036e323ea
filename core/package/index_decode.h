#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/package/index_coding.h"

namespace bosk {

// Tables of chances. What no table names decodes as symbol 0: wrong, but within every bound.
struct TokenSlot {
  std::uint32_t frequency_less_one : 12 = 0, offset : 12 = 0, symbol : 8 = 0;
};
struct DirectRange {
  std::uint16_t frequency = 1, start = 0;
};
struct Chances {
  std::array<std::uint16_t, kLiveContexts> pruned{};  // of "pruned", out of 2^12
  std::vector<TokenSlot> tokens;                      // [context][2^12]
  std::vector<std::uint16_t> direct_symbols;          // [2^14]
  std::vector<DirectRange> direct_ranges;             // [symbol]
};

// A LIVE, ALPH or COLR section ready to be decoded, by any threads, chunk by chunk.
struct CodedIndices {
  std::string name;              // for messages
  bool is_coded = false;         // LIVE: else all blocks are live
  bool goes_by_parents = false;  // ALPH, COLR
  std::uint32_t codewords = 0, ranks = 0;
  Chances chances;
  std::vector<IndexChunk> chunks;
  std::vector<std::vector<std::uint16_t>> words;  // of each chunk, and a 0 behind them
};

// From the decoded bytes of a section. Throw Error on damage and never read beyond `bytes`.
CodedIndices open_live(std::span<const std::byte> bytes, const IndexShape& shape,
                       const std::string& name);
CodedIndices open_indices(std::span<const std::byte> bytes, const IndexShape& shape,
                          std::uint32_t codewords, const std::string& name);

// Both decode one chunk and throw Error on damage. `live`: of the chunk, in view order; 1 for each
// block that draws, 0 for a pruned one.
std::vector<std::uint8_t> decode_live(const CodedIndices& coded, std::size_t chunk);
// Writes the chunk's part of `indices`, the level's in cell order: below `coded.codewords`, or
// `pruned_value` where not live. `parents`: null unless the section goes by them; their indices are
// below `parent_codewords`.
void decode_indices(const CodedIndices& coded, std::size_t chunk,
                    std::span<const std::uint8_t> live, std::uint16_t pruned_value,
                    const ParentIndices* parents, std::uint32_t parent_codewords,
                    std::span<std::uint16_t> indices);

}  // namespace bosk
