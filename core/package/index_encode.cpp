#include "core/package/index_encode.h"

#include <algorithm>
#include <array>

#include "core/package/byte_sink.h"

namespace bosk {
namespace {

// What the walk of a chunk met, in order; coded backwards once the statistics are known. `table`
// counts flags' contexts, or tokens' and then, as the last, the table of direct indices.
struct Event {
  std::uint16_t table = 0, symbol = 0;
};

// A coder for the walks that writes down instead of coding.
struct Recorder {
  std::vector<Event> events;

  bool flag(unsigned context, bool is_live) {
    events.push_back({std::uint16_t(context), is_live});
    return is_live;
  }
  template <class Rank>
  unsigned token(unsigned context, Rank&& rank) {
    const std::uint32_t value = rank();
    events.push_back({std::uint16_t(context), std::uint16_t(value)});
    return value;
  }
  std::uint16_t direct(std::uint16_t value) {
    events.push_back({kTokenContexts, value});
    return value;
  }
};

// Chances of one table's symbols, out of 2^bits.
struct Table {
  unsigned bits = kTokenBits;
  std::vector<std::uint32_t> frequencies, starts;
};

// Frequencies that add up to `one`, none of a symbol that occurs being 0; all 0 when nothing
// occurs.
void scale_to(std::uint32_t one, std::span<std::uint32_t> counts) {
  std::uint64_t total = 0;
  for (const std::uint32_t count : counts) total += count;
  if (total == 0) return;
  std::int64_t rest = one;
  for (std::uint32_t& count : counts) {
    if (count > 0)
      count = std::max<std::uint32_t>(1, std::uint32_t(count * std::uint64_t(one) / total));
    rest -= count;
  }
  while (rest != 0) {  // the largest bear the rounding
    auto& largest = *std::max_element(counts.begin(), counts.end());
    const std::int64_t step = std::max<std::int64_t>(rest, -std::int64_t(largest / 2));
    largest = std::uint32_t(largest + step);
    rest -= step;
  }
}

void finish(Table& table) {
  scale_to(1u << table.bits, table.frequencies);
  std::uint32_t start = 0;
  for (const std::uint32_t frequency : table.frequencies) {
    table.starts.push_back(start);
    start += frequency;
  }
}

std::vector<std::uint16_t> rans_words(const std::vector<Event>& events,
                                      const std::vector<Table>& tables) {
  std::vector<std::uint16_t> words;
  std::array<std::uint32_t, kRansStates> states;
  states.fill(kRansLow);
  for (std::size_t i = events.size(); i-- > 0;) {
    const Table& table = tables[events[i].table];
    const std::uint32_t frequency = table.frequencies[events[i].symbol];
    std::uint32_t& x = states[i % kRansStates];
    if (x >= std::uint64_t(frequency) << (32 - table.bits)) {
      words.push_back(std::uint16_t(x));
      x >>= 16;
    }
    x = (x / frequency << table.bits) + x % frequency + table.starts[events[i].symbol];
  }
  for (std::size_t i = kRansStates; i-- > 0;) {
    words.push_back(std::uint16_t(states[i]));
    words.push_back(std::uint16_t(states[i] >> 16));
  }
  std::reverse(words.begin(), words.end());
  return words;
}

void put_frequencies(ByteSink& sink, const Table& table) {
  const auto& frequencies = table.frequencies;
  std::size_t used = frequencies.size();
  while (used > 0 && frequencies[used - 1] == 0) --used;
  sink.varint(used);
  for (std::size_t symbol = 0; symbol < used; ++symbol) {
    sink.varint(frequencies[symbol]);
    if (frequencies[symbol] != 0) continue;
    const std::size_t first = symbol;
    while (frequencies[symbol + 1] == 0) ++symbol;
    sink.varint(symbol - first);
  }
}

// 1 for each index that is not kPruned.
std::vector<std::uint8_t> live_blocks(const std::vector<std::uint16_t>& alpha) {
  std::vector<std::uint8_t> live;
  live.reserve(alpha.size());
  for (const std::uint16_t index : alpha) live.push_back(index != kPruned);
  return live;
}

void count(const std::vector<Recorder>& chunks, std::vector<Table>& tables) {
  for (const Recorder& chunk : chunks) {
    for (const Event& event : chunk.events) ++tables[event.table].frequencies[event.symbol];
  }
  for (Table& table : tables) finish(table);
}

void put_words(ByteSink& sink, const std::vector<Recorder>& chunks,
               const std::vector<Table>& tables) {
  ByteSink words;
  for (const Recorder& chunk : chunks) {
    const auto coded = rans_words(chunk.events, tables);
    sink.value(std::uint32_t(coded.size()));
    words.append(std::as_bytes(std::span(coded)));
  }
  sink.append(words.bytes);
}

// Longer lists tell more; beyond half a megabyte they grow out of a processor's cache.
std::uint32_t list_length(std::uint32_t befores) {
  constexpr std::uint32_t kCachedEntries = 1 << 18;
  return std::clamp(kCachedEntries / std::max<std::uint32_t>(1, befores), 16u, kMaxRanks);
}

}  // namespace

std::vector<std::byte> encode_live(std::span<const std::uint16_t> alpha, const IndexShape& shape) {
  const bool is_coded = std::find(alpha.begin(), alpha.end(), kPruned) != alpha.end();
  if (!is_coded) return {std::byte(0)};
  std::vector<Recorder> chunks;
  for (const IndexChunk& chunk : index_chunks(shape)) {
    auto flags = live_blocks(view_order(chunk.of(alpha), chunk.shape));
    chunks.push_back(walk_live(chunk.shape, flags, Recorder{}));
  }
  // Both flags stay possible in every context: the reader wants no empty range.
  std::vector<Table> tables(kLiveContexts, {kTokenBits, {1, 1}, {}});
  count(chunks, tables);
  ByteSink sink{{std::byte(1)}};
  for (const Table& table : tables) sink.value(std::uint16_t(table.frequencies[0]));
  put_words(sink, chunks, tables);
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_indices(std::span<const std::uint16_t> indices,
                                      std::span<const std::uint16_t> alpha, const IndexShape& shape,
                                      std::uint32_t codewords, const ParentIndices* parents,
                                      std::uint32_t parent_codewords) {
  const std::uint32_t befores = std::max(codewords, parents ? parent_codewords : 0);
  const std::uint32_t ranks = list_length(befores);
  std::vector<Recorder> chunks;
  for (const IndexChunk& chunk : index_chunks(shape)) {
    const auto live = live_blocks(view_order(chunk.of(alpha), chunk.shape));
    auto values = view_order(chunk.of(indices), chunk.shape);
    chunks.push_back(walk_indices(live, first_past(chunk, parents),
                                  RankLists(befores, codewords, ranks), values, Recorder{}));
  }
  std::vector<Table> tables(kTokenContexts,
                            {kTokenBits, std::vector<std::uint32_t>(kMaxRanks + 1), {}});
  tables.push_back({kDirectBits, std::vector<std::uint32_t>(codewords), {}});
  count(chunks, tables);
  ByteSink sink;
  sink.value(std::uint8_t(parents != nullptr));
  sink.value(std::uint8_t(ranks));
  for (const Table& table : tables) put_frequencies(sink, table);
  put_words(sink, chunks, tables);
  return std::move(sink.bytes);
}

}  // namespace bosk
