#include "core/package/index_encode.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/package/byte_sink.h"

namespace bosk {
namespace {

// What the walk met, in order; coded backwards once the statistics are known.
struct Event {
  std::uint16_t context = 0;
  std::uint16_t symbol = 0;
};
constexpr std::uint16_t kFlagEvent = 0x8000;  // in `context`

struct Range {
  std::uint32_t frequency = 0, start = 0;  // out of 2^12
};

class BitWriter {
 public:
  void bits(std::uint32_t value, unsigned count) {
    buffer_ |= std::uint64_t(value) << held_;
    for (held_ += count; held_ >= 8; held_ -= 8, buffer_ >>= 8) put();
  }
  std::vector<std::byte> finish() {
    if (held_ > 0) put();
    held_ = 0;
    return std::move(bytes_);
  }

 private:
  void put() { bytes_.push_back(std::byte(buffer_ & 0xff)); }
  std::vector<std::byte> bytes_;
  std::uint64_t buffer_ = 0;
  unsigned held_ = 0;
};

// A coder for the walk that writes down instead of coding.
class Recorder {
 public:
  explicit Recorder(const NearCodewords& near) : near_(near) {}

  bool flag(unsigned context, bool is_live) {
    events.push_back({std::uint16_t(context | kFlagEvent), std::uint16_t(is_live)});
    return is_live;
  }
  std::uint16_t index(unsigned context, std::uint16_t expected, std::uint16_t value) {
    const auto list = near_.of(expected);
    const auto found = std::find(list.begin(), list.end(), value);
    const auto rank = std::uint32_t(found - list.begin());
    const bool is_near = found != list.end();
    events.push_back({std::uint16_t(context),
                      std::uint16_t(is_near ? rank : near_.length + escape(expected, value))});
    return value;
  }
  std::vector<Event> events;
  BitWriter bits;

 private:
  std::uint32_t escape(std::uint16_t expected, std::uint16_t value) {
    const std::int32_t difference = std::int32_t(value) - std::int32_t(expected);
    const auto zigzag = std::uint32_t(difference < 0 ? -2 * difference - 1 : 2 * difference);
    const auto bit_count = unsigned(std::bit_width(zigzag));
    if (bit_count > 1) bits.bits(zigzag - (1u << (bit_count - 1)), bit_count - 1);
    return bit_count;
  }
  const NearCodewords& near_;
};

// Frequencies that add up to 2^12, none of a symbol that occurs being 0; all 0 when nothing occurs.
void scale_to_one(std::span<std::uint32_t> counts) {
  std::uint64_t total = 0;
  for (const std::uint32_t count : counts) total += count;
  if (total == 0) return;
  std::int64_t rest = kProbabilityOne;
  for (std::uint32_t& count : counts) {
    if (count > 0)
      count =
          std::max<std::uint32_t>(1, std::uint32_t(count * std::uint64_t(kProbabilityOne) / total));
    rest -= count;
  }
  while (rest != 0) {  // the largest bears the rounding; at most one step a symbol
    auto& largest = *std::max_element(counts.begin(), counts.end());
    const std::int64_t step = std::max<std::int64_t>(rest, 1 - std::int64_t(largest));
    largest = std::uint32_t(largest + step);
    rest -= step;
  }
}

struct Statistics {
  std::array<std::array<std::uint32_t, 2>, kFlagContexts> flags{};
  std::vector<std::vector<std::uint32_t>> tokens;  // [context][token]

  Range range(const Event& event) const {
    if (event.context & kFlagEvent) return range_of(flags[event.context & 0xffu], event.symbol);
    return range_of(tokens[event.context], event.symbol);
  }

 private:
  static Range range_of(std::span<const std::uint32_t> frequencies, unsigned symbol) {
    Range range{frequencies[symbol], 0};
    for (unsigned before = 0; before < symbol; ++before) range.start += frequencies[before];
    return range;
  }
};

Statistics gather(const std::vector<Event>& events, unsigned contexts) {
  Statistics statistics;
  statistics.tokens.assign(contexts, std::vector<std::uint32_t>(kMaxNear + kEscapeTokens));
  for (auto& flag : statistics.flags)
    flag = {1, 1};  // both stay possible: a decoder's interval is never empty
  for (const Event& event : events) {
    const bool is_flag = event.context & kFlagEvent;
    ++(is_flag ? statistics.flags[event.context & 0xffu][event.symbol]
               : statistics.tokens[event.context][event.symbol]);
  }
  for (auto& flag : statistics.flags) scale_to_one(flag);
  for (auto& tokens : statistics.tokens) scale_to_one(tokens);
  return statistics;
}

std::vector<std::uint16_t> rans_words(const std::vector<Event>& events,
                                      const Statistics& statistics) {
  std::vector<std::uint16_t> words;
  std::uint32_t state[2] = {kRansLow, kRansLow};
  for (std::size_t i = events.size(); i-- > 0;) {
    std::uint32_t& x = state[i & 1];
    const Range range = statistics.range(events[i]);
    if (x >= std::uint64_t(range.frequency) << (32 - kProbabilityBits)) {
      words.push_back(std::uint16_t(x));
      x >>= 16;
    }
    x = (x / range.frequency << kProbabilityBits) + x % range.frequency + range.start;
  }
  for (const std::uint32_t x : {state[1], state[0]}) {
    words.push_back(std::uint16_t(x));
    words.push_back(std::uint16_t(x >> 16));
  }
  std::reverse(words.begin(), words.end());
  return words;
}

void put_tables(ByteSink& sink, const Statistics& statistics, bool with_flags) {
  for (std::size_t i = 0; with_flags && i < kFlagContexts; ++i) {
    sink.value(std::uint16_t(statistics.flags[i][0]));
  }
  for (const auto& tokens : statistics.tokens) {
    std::size_t used = tokens.size();
    while (used > 0 && tokens[used - 1] == 0) --used;
    sink.value(std::uint8_t(used));
    for (std::size_t token = 0; token < used; ++token) sink.varint(tokens[token]);
  }
}

std::vector<std::byte> coded(Recorder recorder, const NearCodewords& near, unsigned buckets,
                             bool with_flags) {
  const Statistics statistics = gather(recorder.events, buckets + 1);
  const auto words = rans_words(recorder.events, statistics);
  const auto bits = recorder.bits.finish();
  ByteSink sink;
  sink.value(std::uint8_t(IndexTransform::ranked));
  sink.value(std::uint8_t(near.length));
  sink.value(std::uint8_t(buckets));
  sink.value(std::uint8_t(0));
  sink.value(std::uint32_t(words.size()));
  sink.value(std::uint32_t(bits.size()));
  put_tables(sink, statistics, with_flags);
  sink.append(std::as_bytes(std::span(words)));
  sink.append(bits);
  return std::move(sink.bytes);
}

}  // namespace

std::vector<std::byte> encode_planes(std::span<const std::uint16_t> indices,
                                     const IndexShape& shape) {
  const auto values = view_order(indices, shape);
  std::vector<std::byte> bytes(1 + 2 * values.size());
  bytes[0] = std::byte(IndexTransform::planes);
  for (std::size_t i = 0; i < values.size(); ++i) {
    bytes[1 + i] = std::byte(values[i] & 0xff);
    bytes[1 + values.size() + i] = std::byte(values[i] >> 8);
  }
  return bytes;
}

std::vector<std::byte> encode_ranked_alpha(std::span<const std::uint16_t> indices,
                                           const IndexShape& shape, const NearCodewords& near,
                                           unsigned buckets) {
  auto values = view_order(indices, shape);
  const IndexPredictor predictor(shape, near.count, buckets);
  return coded(walk_alpha(shape, predictor, values, Recorder(near)), near, buckets, true);
}

std::vector<std::byte> encode_ranked_colour(std::span<const std::uint16_t> indices,
                                            std::span<const std::uint16_t> alpha_indices,
                                            const IndexShape& shape, const NearCodewords& near,
                                            unsigned buckets) {
  auto values = view_order(indices, shape);
  const auto alpha = view_order(alpha_indices, shape);
  const IndexPredictor predictor(shape, near.count, buckets);
  return coded(walk_colour(shape, predictor, alpha, values, Recorder(near)), near, buckets, false);
}

}  // namespace bosk
