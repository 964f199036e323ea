#include "core/package/index_encode.h"

#include <algorithm>

#include "core/package/byte_sink.h"

namespace bosk {
namespace {

// What a walk met, in order; coded backwards once the statistics are known. `table` counts flags'
// contexts, or tokens' and then, as the last, the table of direct indices.
struct Event {
  std::uint16_t table = 0, symbol = 0;
};

// A coder for the walks that writes down instead of coding.
struct Recorder {
  std::uint16_t direct_table = 0;
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
    events.push_back({direct_table, value});
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
  std::uint32_t state[2] = {kRansLow, kRansLow};
  for (std::size_t i = events.size(); i-- > 0;) {
    const Table& table = tables[events[i].table];
    const std::uint32_t frequency = table.frequencies[events[i].symbol];
    std::uint32_t& x = state[i & 1];
    if (x >= std::uint64_t(frequency) << (32 - table.bits)) {
      words.push_back(std::uint16_t(x));
      x >>= 16;
    }
    x = (x / frequency << table.bits) + x % frequency + table.starts[events[i].symbol];
  }
  for (const std::uint32_t x : {state[1], state[0]}) {
    words.push_back(std::uint16_t(x));
    words.push_back(std::uint16_t(x >> 16));
  }
  std::reverse(words.begin(), words.end());
  return words;
}

void put_frequencies(ByteSink& sink, const Table& table) {
  std::size_t used = table.frequencies.size();
  while (used > 0 && table.frequencies[used - 1] == 0) --used;
  sink.varint(used);
  for (std::size_t symbol = 0; symbol < used; ++symbol) sink.varint(table.frequencies[symbol]);
}

}  // namespace

std::vector<std::uint8_t> live_blocks(std::span<const std::uint16_t> alpha_in_view_order) {
  std::vector<std::uint8_t> live;
  for (const std::uint16_t index : alpha_in_view_order) live.push_back(index != kPruned);
  return live;
}

std::vector<std::byte> encode_live(std::span<const std::uint8_t> live, const IndexShape& shape) {
  std::vector<std::uint8_t> flags(live.begin(), live.end());
  const Recorder recorder = walk_live(shape, flags, Recorder{});
  // Both flags stay possible in every context: the reader wants no empty range.
  std::vector<Table> tables(kLiveContexts, {kTokenBits, {1, 1}, {}});
  for (const Event& event : recorder.events) ++tables[event.table].frequencies[event.symbol];
  ByteSink sink;
  for (Table& table : tables) {
    finish(table);
    sink.value(std::uint16_t(table.frequencies[0]));
  }
  const auto words = rans_words(recorder.events, tables);
  sink.append(std::as_bytes(std::span(words)));
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_planes(std::span<const std::uint16_t> indices,
                                     std::span<const std::uint8_t> live) {
  ByteSink sink, high;
  sink.value(std::uint8_t(IndexTransform::planes));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (live[i] == 0) continue;
    sink.value(std::uint8_t(indices[i] & 0xff));
    high.value(std::uint8_t(indices[i] >> 8));
  }
  sink.append(high.bytes);
  return std::move(sink.bytes);
}

std::vector<std::byte> encode_ranked(std::span<const std::uint16_t> indices,
                                     std::span<const std::uint8_t> live, const IndexShape& shape,
                                     std::uint32_t codewords, unsigned ranks, unsigned buckets) {
  std::vector<std::uint16_t> values(indices.begin(), indices.end());
  const Recorder recorder =
      walk_indices(shape, live, codewords, buckets, RankLists(codewords, ranks), values,
                   Recorder{std::uint16_t(buckets), {}});
  std::vector<Table> tables(buckets, {kTokenBits, std::vector<std::uint32_t>(kMaxRanks + 1), {}});
  tables.push_back({kDirectBits, std::vector<std::uint32_t>(codewords), {}});
  for (const Event& event : recorder.events) ++tables[event.table].frequencies[event.symbol];
  ByteSink sink;
  sink.value(std::uint8_t(IndexTransform::ranked));
  sink.value(std::uint8_t(ranks));
  sink.value(std::uint8_t(buckets));
  for (Table& table : tables) {
    finish(table);
    put_frequencies(sink, table);
  }
  const auto words = rans_words(recorder.events, tables);
  sink.append(std::as_bytes(std::span(words)));
  return std::move(sink.bytes);
}

}  // namespace bosk
