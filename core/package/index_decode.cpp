#include "core/package/index_decode.h"

#include <array>
#include <numeric>

#include "core/package/byte_cursor.h"

namespace bosk {
namespace {

// Which symbol a slot of a context's 2^12 belongs to.
struct TokenSlot {
  std::uint32_t frequency_less_one : 12 = 0, offset : 12 = 0, symbol : 8 = 0;
};
struct DirectRange {
  std::uint16_t frequency = 1, start = 0;
};

// Tables of chances. What no table names decodes as symbol 0: wrong, but within every bound.
struct Chances {
  std::array<std::uint16_t, kLiveContexts> pruned{};  // of "pruned", out of 2^12
  std::vector<TokenSlot> tokens;                      // [context][2^12]
  std::vector<std::uint16_t> direct_symbols;          // [2^14]
  std::vector<DirectRange> direct_ranges;             // [symbol]
};

// Duda's asymmetric numeral systems, range variant, two states in turn so that a processor can work
// on both. No branch depends on the data. Words beyond the end read as 0 and are told by
// `finished`.
class RansDecoder {
 public:
  // `words` must have one word behind them that may be read, and outlive the decoder; as `chances`
  // must.
  RansDecoder(std::span<const std::uint16_t> words, const Chances& chances)
      : next_(words.data()),
        end_(words.data() + words.size()),
        pruned_(chances.pruned.data()),
        tokens_(chances.tokens.data()),
        direct_symbols_(chances.direct_symbols.data()),
        direct_ranges_(chances.direct_ranges.data()) {
    state_ = start();
    other_ = start();
  }

  bool flag(unsigned context, bool) {
    const std::uint32_t pruned = pruned_[context], low = low_bits<kTokenBits>();
    const bool is_live = low >= pruned;
    advance<kTokenBits>(is_live ? (1u << kTokenBits) - pruned : pruned,
                        is_live ? low - pruned : low);
    return is_live;
  }
  template <class Rank>
  unsigned token(unsigned context, Rank&&) {
    const TokenSlot slot = tokens_[context << kTokenBits | low_bits<kTokenBits>()];
    advance<kTokenBits>(slot.frequency_less_one + 1, slot.offset);
    return slot.symbol;
  }
  std::uint16_t direct(std::uint16_t) {
    const std::uint32_t low = low_bits<kDirectBits>();
    const std::uint16_t symbol = direct_symbols_[low];
    advance<kDirectBits>(direct_ranges_[symbol].frequency, low - direct_ranges_[symbol].start);
    return symbol;
  }
  // The coder began with both states at the lower end, so a sound stream ends there.
  bool finished() const { return next_ == end_ && state_ == kRansLow && other_ == kRansLow; }

 private:
  template <unsigned kBits>
  std::uint32_t low_bits() const {
    return state_ & ((1u << kBits) - 1);
  }
  template <unsigned kBits>
  void advance(std::uint32_t frequency, std::uint32_t offset) {
    const std::uint32_t state = frequency * (state_ >> kBits) + offset;
    const std::uint32_t more = state << 16 | *next_;
    const bool is_low = state < kRansLow;
    next_ += is_low && next_ != end_;
    state_ = other_;
    other_ = is_low ? more : state;
  }
  std::uint32_t start() {
    if (end_ - next_ < 2) return 0;
    next_ += 2;
    return std::uint32_t(next_[-2]) << 16 | next_[-1];
  }

  const std::uint16_t *next_, *end_;
  const std::uint16_t* pruned_;
  const TokenSlot* tokens_;
  const std::uint16_t* direct_symbols_;
  const DirectRange* direct_ranges_;
  std::uint32_t state_ = 0, other_ = 0;
};

// Frequencies of symbols 0 up, which add up to `one`, or none at all.
std::vector<std::uint32_t> read_frequencies(ByteCursor& cursor, std::uint32_t max_symbols,
                                            std::uint32_t one) {
  const std::uint64_t count = cursor.varint();
  if (count > max_symbols) damaged(cursor.section() + ": too many symbols");
  std::vector<std::uint32_t> frequencies;
  std::uint64_t left = count == 0 ? 0 : one;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t frequency = cursor.varint();
    if (frequency > left) damaged(cursor.section() + ": chances beyond 1");
    left -= frequency;
    frequencies.push_back(std::uint32_t(frequency));
  }
  if (left != 0) damaged(cursor.section() + ": chances below 1");
  return frequencies;
}

void read_tokens(ByteCursor& cursor, std::uint32_t max_symbols, std::span<TokenSlot> slots) {
  std::uint32_t symbol = 0;
  std::size_t filled = 0;
  for (const std::uint32_t frequency : read_frequencies(cursor, max_symbols, 1u << kTokenBits)) {
    for (std::uint32_t offset = 0; offset < frequency; ++offset) {
      slots[filled++] = {(frequency - 1) & 0xfff, offset & 0xfff, symbol & 0xff};
    }
    ++symbol;
  }
}

void read_direct(ByteCursor& cursor, std::uint32_t codewords, Chances& chances) {
  const auto frequencies = read_frequencies(cursor, codewords, 1u << kDirectBits);
  chances.direct_symbols.assign(std::size_t(1) << kDirectBits, 0);
  chances.direct_ranges.assign(codewords, {});
  std::uint32_t start = 0;
  for (std::uint32_t symbol = 0; symbol < frequencies.size(); ++symbol) {
    chances.direct_ranges[symbol] = {std::uint16_t(frequencies[symbol]), std::uint16_t(start)};
    std::fill_n(chances.direct_symbols.begin() + start, frequencies[symbol], std::uint16_t(symbol));
    start += frequencies[symbol];
  }
}

// The rest of the section as words, and a 0 behind them.
std::vector<std::uint16_t> read_words(ByteCursor& cursor) {
  auto words = cursor.array<std::uint16_t>(cursor.left() / 2);
  cursor.expect_end();
  words.push_back(0);
  return words;
}

std::span<const std::uint16_t> without_last(const std::vector<std::uint16_t>& words) {
  return {words.data(), words.size() - 1};
}

void decode_planes(ByteCursor& cursor, std::span<const std::uint8_t> live,
                   std::span<std::uint16_t> values) {
  const std::size_t count = cursor.left() / 2;
  const auto low = cursor.take(count), high = cursor.take(count);
  cursor.expect_end();
  if (std::accumulate(live.begin(), live.end(), std::size_t(0)) != count) {
    damaged(cursor.section() + ": number of indices");
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (live[i] == 0) continue;
    values[i] = std::uint16_t(unsigned(low[next]) | unsigned(high[next]) << 8);
    ++next;
  }
}

void decode_ranked(ByteCursor& cursor, const IndexShape& shape, std::span<const std::uint8_t> live,
                   std::uint32_t codewords, std::span<std::uint16_t> values) {
  const std::uint32_t length = cursor.value<std::uint8_t>(), buckets = cursor.value<std::uint8_t>();
  if (length < 1 || buckets < 1 || buckets > kMaxBuckets || codewords < 1) {
    damaged(cursor.section() + ": parameters of the index coding");
  }
  RankLists lists(codewords, length);
  Chances chances;
  chances.tokens.resize(std::size_t(buckets) << kTokenBits);
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    read_tokens(cursor, lists.length() + 1,
                std::span(chances.tokens).subspan(bucket << kTokenBits, 1u << kTokenBits));
  }
  read_direct(cursor, codewords, chances);
  const auto words = read_words(cursor);
  const auto ended = walk_indices(shape, live, codewords, buckets, std::move(lists), values,
                                  RansDecoder(without_last(words), chances));
  if (!ended.finished()) damaged(cursor.section() + ": coded indices do not end well");
}

}  // namespace

std::vector<std::uint8_t> decode_live(std::span<const std::byte> bytes, const IndexShape& shape,
                                      const std::string& name) {
  ByteCursor cursor(bytes, name);
  Chances chances;
  for (std::uint16_t& chance : chances.pruned) {
    chance = cursor.value<std::uint16_t>();
    if (chance == 0 || chance >= 1u << kTokenBits) damaged(name + ": chances");
  }
  const auto words = read_words(cursor);
  std::vector<std::uint8_t> live(shape.count());
  const auto ended = walk_live(shape, live, RansDecoder(without_last(words), chances));
  if (!ended.finished()) damaged(name + ": coded flags do not end well");
  return live;
}

std::vector<std::uint16_t> decode_indices(std::span<const std::byte> bytes, const IndexShape& shape,
                                          std::span<const std::uint8_t> live,
                                          std::uint32_t codewords, std::uint16_t pruned_value,
                                          const std::string& name) {
  ByteCursor cursor(bytes, name);
  std::vector<std::uint16_t> values(shape.count(), pruned_value);
  const auto transform = IndexTransform(cursor.value<std::uint8_t>());
  if (transform == IndexTransform::planes) {
    decode_planes(cursor, live, values);
  } else if (transform == IndexTransform::ranked) {
    decode_ranked(cursor, shape, live, codewords, values);
  } else {
    damaged(name + ": unknown coding of indices");
  }
  return cell_order(values, shape);
}

}  // namespace bosk
