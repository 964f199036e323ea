#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/content_hash.h"
#include "core/base/error.h"
#include "core/compress/blocks.h"

namespace bosk {
namespace {

constexpr std::size_t kShards = 256;  // each is sorted alone, so that a job can stop between two
constexpr std::size_t kGrain = 4096;

// A block's content and its share of the kind's weight; weight 0: pruned, in no kind.
struct Fingerprint {
  ContentHash hash;
  float weight = 0.0f;
};

// Where the colour is constant, alpha is no part of the content but says how much the block counts.
Fingerprint colour_fingerprint(const BlockTexels& texels) {
  if (is_pruned(texels)) return {};
  const bool constant = is_constant(texels);
  BlockTexels visible{};
  unsigned alpha = 0;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    alpha += texels[i].a;
    if (texels[i].a > 0) visible[constant ? 0 : i] = texels[i];
  }
  if (constant) visible[0].a = 0;
  return {content_hash(std::as_bytes(std::span(visible))),
          constant ? float(alpha) / (16.0f * 255.0f) : 1.0f};
}

Fingerprint alpha_fingerprint(const BlockTexels& texels) {
  if (is_pruned(texels)) return {};
  const BlockAlphas alphas = block_alphas(texels);
  return {content_hash(std::as_bytes(std::span(alphas))), 1.0f};
}

using Fingerprints = std::vector<Fingerprint>;

template <class Function>
Fingerprints all_fingerprints(const BillboardLevel& level, Function&& fingerprint,
                              Progress& progress) {
  Fingerprints prints(block_count(level));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, prints.size(), kGrain), [&](auto range) {
    progress.check();
    for (std::size_t block = range.begin(); block < range.end(); ++block) {
      prints[block] = fingerprint(block_texels(level, block));
    }
  });
  return prints;
}

std::size_t shard_of(const Fingerprint& print) { return print.hash.high % kShards; }

// Blocks that count, shard after shard; `first` has each shard's start and the end.
std::vector<std::uint32_t> blocks_by_shard(const Fingerprints& prints,
                                           std::vector<std::size_t>& first) {
  first.assign(kShards + 1, 0);
  for (const Fingerprint& print : prints) {
    if (print.weight > 0.0f) ++first[shard_of(print) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> blocks(first.back());
  std::vector<std::size_t> next = first;
  for (std::uint32_t block = 0; block < prints.size(); ++block) {
    if (prints[block].weight > 0.0f) blocks[next[shard_of(prints[block])]++] = block;
  }
  return blocks;
}

// For each block the first one with the same content; kNoKind where pruned.
std::vector<std::uint32_t> leaders(const Fingerprints& prints, Progress& progress) {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> blocks = blocks_by_shard(prints, first);
  std::vector<std::uint32_t> leader(prints.size(), kNoKind);
  tbb::parallel_for(std::size_t(0), kShards, [&](std::size_t shard) {
    progress.check();
    const auto members = std::span(blocks).subspan(first[shard], first[shard + 1] - first[shard]);
    std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
      return prints[a].hash != prints[b].hash ? prints[a].hash < prints[b].hash : a < b;
    });
    for (std::size_t i = 0; i < members.size(); ++i) {
      const bool repeats = i > 0 && prints[members[i]].hash == prints[members[i - 1]].hash;
      leader[members[i]] = repeats ? leader[members[i - 1]] : members[i];
    }
  });
  return leader;
}

DistinctBlocks number_kinds(const Fingerprints& prints, std::vector<std::uint32_t> leader) {
  DistinctBlocks result;
  std::vector<double> weights;
  for (std::uint32_t block = 0; block < prints.size(); ++block) {
    if (leader[block] == kNoKind) continue;
    if (leader[block] == block) {
      leader[block] = std::uint32_t(result.first_block.size());
      result.first_block.push_back(block);
      weights.push_back(0.0);
    } else {
      leader[block] = leader[leader[block]];  // an earlier block, numbered already
    }
    weights[leader[block]] += double(prints[block].weight);
  }
  result.weight.assign(weights.begin(), weights.end());
  result.kind_of_block = std::move(leader);
  return result;
}

template <class Function>
DistinctBlocks distinct(const BillboardLevel& level, Function&& fingerprint, Progress& progress) {
  if (block_count(level) >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("billboard level " + std::to_string(level.level) +
                " has more than 4 billion blocks; use fewer views or a coarser level");
  }
  const Fingerprints prints = all_fingerprints(level, fingerprint, progress);
  return number_kinds(prints, leaders(prints, progress));
}

}  // namespace

DistinctBlocks distinct_colours(const BillboardLevel& level, Progress& progress) {
  return distinct(level, colour_fingerprint, progress);
}

DistinctBlocks distinct_alphas(const BillboardLevel& level, Progress& progress) {
  return distinct(level, alpha_fingerprint, progress);
}

}  // namespace bosk
