#include "core/compress/code_kinds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace bosk {
namespace {

std::vector<std::uint16_t> encode_kinds(std::size_t kinds, const MakeVectors& make_vectors,
                                        const CodewordTable& table, Progress& progress) {
  std::vector<std::uint16_t> indices(kinds);
  const std::size_t chunks = (kinds + kEncodeChunk - 1) / kEncodeChunk;
  tbb::parallel_for(std::size_t(0), chunks, [&](std::size_t chunk) {
    const std::size_t first = chunk * kEncodeChunk;
    const std::size_t count = std::min(kEncodeChunk, kinds - first);
    std::vector<std::uint32_t> members(count);
    std::iota(members.begin(), members.end(), std::uint32_t(first));
    const VectorSet vectors = make_vectors(members, std::vector<float>(count, 1.0f));
    encode(vectors, table, 0, std::span(indices).subspan(first, count));
    progress.advance();
  });
  return indices;
}

// Leaves out codewords that stand for nothing.
KindCodes without_unused(std::vector<std::uint16_t> indices, std::size_t codewords) {
  std::vector<std::uint16_t> number(codewords);
  for (const std::uint16_t index : indices) number[index] = 1;
  std::uint16_t used = 0;
  for (std::uint16_t& n : number) n = n != 0 ? used++ : std::uint16_t(0);
  for (std::uint16_t& index : indices) index = number[index];
  return {std::move(indices), used};
}

}  // namespace

std::size_t code_kinds_units(std::size_t blocks, const TrainingOptions& options) {
  return std::size_t(options.max_rounds) + (blocks + kEncodeChunk - 1) / kEncodeChunk;
}

KindCodes code_kinds(const DistinctBlocks& blocks, const MakeVectors& make_vectors,
                     const TrainingOptions& options, std::size_t training_blocks,
                     Progress& progress) {
  const std::size_t kinds = blocks.first_block.size();
  if (kinds <= std::size_t(options.codewords)) {
    std::vector<std::uint16_t> own(kinds);
    std::iota(own.begin(), own.end(), std::uint16_t(0));
    return {std::move(own), kinds};
  }
  const KindSample sample = sample_kinds(blocks, training_blocks);
  const VectorSet vectors = make_vectors(sample.kinds, sample.weights);
  const Codebook codebook = train_codebook(vectors, options, progress);
  progress.advance(std::size_t(options.max_rounds - codebook.rounds));
  return without_unused(encode_kinds(kinds, make_vectors, search_table(codebook), progress),
                        codebook.size());
}

std::vector<std::uint16_t> block_codes(const DistinctBlocks& blocks,
                                       std::span<const std::uint16_t> kind_codes,
                                       std::uint16_t pruned) {
  std::vector<std::uint16_t> codes(blocks.kind_of_block.size());
  std::transform(blocks.kind_of_block.begin(), blocks.kind_of_block.end(), codes.begin(),
                 [&](std::uint32_t kind) { return kind == kNoKind ? pruned : kind_codes[kind]; });
  return codes;
}

}  // namespace bosk
