#include "core/package/index_decode.h"

#include <algorithm>

#include "core/package/byte_cursor.h"

namespace bosk {
namespace {

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
    for (std::uint32_t& state : states_) state = start();
  }

  bool flag(unsigned context, bool) {
    constexpr std::uint32_t kOne = 1u << kTokenBits;
    const std::uint32_t pruned = pruned_[context], low = low_bits<kTokenBits>();
    const std::uint32_t is_live = low >= pruned, if_live = 0 - is_live;
    advance<kTokenBits>(pruned + (if_live & (kOne - 2 * pruned)), low - (if_live & pruned));
    return is_live != 0;
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
  bool finished() const {
    return next_ == end_ && std::all_of(states_.begin(), states_.end(),
                                        [](std::uint32_t state) { return state == kRansLow; });
  }

 private:
  template <unsigned kBits>
  std::uint32_t low_bits() const {
    return states_[0] & ((1u << kBits) - 1);
  }
  template <unsigned kBits>
  void advance(std::uint32_t frequency, std::uint32_t offset) {
    const std::uint32_t state = frequency * (states_[0] >> kBits) + offset;
    const std::uint32_t is_low = state < kRansLow;
    const std::uint32_t more = (0 - is_low) & *next_;
    next_ += is_low & std::uint32_t(next_ != end_);
    for (unsigned i = 1; i < kRansStates; ++i) states_[i - 1] = states_[i];
    states_[kRansStates - 1] = state << 16 * is_low | more;
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
  std::array<std::uint32_t, kRansStates> states_{};
};

// Frequencies of symbols 0 up, which add up to `one`, or none at all. A 0 is followed by how many
// more there are.
std::vector<std::uint32_t> read_frequencies(ByteCursor& cursor, std::uint32_t max_symbols,
                                            std::uint32_t one) {
  const std::uint64_t count = cursor.varint();
  if (count > max_symbols) damaged(cursor.section() + ": too many symbols");
  std::vector<std::uint32_t> frequencies;
  std::uint64_t left = count == 0 ? 0 : one;
  while (frequencies.size() < count) {
    const std::uint64_t frequency = cursor.varint();
    if (frequency > left) damaged(cursor.section() + ": chances beyond 1");
    const std::uint64_t more = frequency == 0 ? cursor.varint() : 0;
    if (more >= count - frequencies.size()) damaged(cursor.section() + ": too many symbols");
    frequencies.resize(frequencies.size() + more + 1, std::uint32_t(frequency));
    left -= frequency;
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
  chances.direct_ranges.assign(std::max<std::size_t>(1, codewords), {});
  std::uint32_t start = 0;
  for (std::uint32_t symbol = 0; symbol < frequencies.size(); ++symbol) {
    chances.direct_ranges[symbol] = {std::uint16_t(frequencies[symbol]), std::uint16_t(start)};
    std::fill_n(chances.direct_symbols.begin() + start, frequencies[symbol], std::uint16_t(symbol));
    start += frequencies[symbol];
  }
}

// The rest of the section: how many words each chunk has, then their words.
void read_words(ByteCursor& cursor, CodedIndices& coded) {
  const auto lengths = cursor.array<std::uint32_t>(coded.chunks.size());
  for (const std::uint32_t length : lengths) {
    coded.words.push_back(cursor.array<std::uint16_t>(length));
    coded.words.back().push_back(0);
  }
  cursor.expect_end();
}

RansDecoder decoder_of(const CodedIndices& coded, std::size_t chunk) {
  const std::vector<std::uint16_t>& words = coded.words[chunk];
  return {{words.data(), words.size() - 1}, coded.chances};
}

}  // namespace

CodedIndices open_live(std::span<const std::byte> bytes, const IndexShape& shape,
                       const std::string& name) {
  ByteCursor cursor(bytes, name);
  CodedIndices coded;
  coded.name = name;
  const auto kind = cursor.value<std::uint8_t>();
  if (kind > 1) damaged(name + ": unknown coding of flags");
  coded.is_coded = kind == 1;
  coded.chunks = index_chunks(shape);
  if (!coded.is_coded) {
    cursor.expect_end();
    return coded;
  }
  for (std::uint16_t& chance : coded.chances.pruned) {
    chance = cursor.value<std::uint16_t>();
    if (chance == 0 || chance >= 1u << kTokenBits) damaged(name + ": chances");
  }
  read_words(cursor, coded);
  return coded;
}

CodedIndices open_indices(std::span<const std::byte> bytes, const IndexShape& shape,
                          std::uint32_t codewords, const std::string& name) {
  ByteCursor cursor(bytes, name);
  CodedIndices coded;
  coded.name = name;
  const auto kind = cursor.value<std::uint8_t>(), ranks = cursor.value<std::uint8_t>();
  if (kind > 1 || ranks < 1) damaged(name + ": unknown coding of indices");
  coded.goes_by_parents = kind == 1;
  coded.codewords = codewords;
  coded.ranks = std::min<std::uint32_t>(ranks, codewords);
  coded.chances.tokens.resize(std::size_t(kTokenContexts) << kTokenBits);
  for (std::size_t context = 0; context < kTokenContexts; ++context) {
    read_tokens(cursor, coded.ranks + 1,
                std::span(coded.chances.tokens).subspan(context << kTokenBits, 1u << kTokenBits));
  }
  read_direct(cursor, codewords, coded.chances);
  coded.chunks = index_chunks(shape);
  read_words(cursor, coded);
  return coded;
}

std::vector<std::uint8_t> decode_live(const CodedIndices& coded, std::size_t chunk) {
  const IndexShape& shape = coded.chunks[chunk].shape;
  std::vector<std::uint8_t> live(shape.count(), 1);
  if (!coded.is_coded) return live;
  const auto ended = walk_live(shape, live, decoder_of(coded, chunk));
  if (!ended.finished()) damaged(coded.name + ": coded flags do not end well");
  return live;
}

void decode_indices(const CodedIndices& coded, std::size_t chunk,
                    std::span<const std::uint8_t> live, std::uint16_t pruned_value,
                    const ParentIndices* parents, std::uint32_t parent_codewords,
                    std::span<std::uint16_t> indices) {
  if (coded.codewords == 0 && std::find(live.begin(), live.end(), 1) != live.end()) {
    damaged(coded.name + ": indices without codewords");
  }
  const IndexChunk& part = coded.chunks[chunk];
  std::vector<std::uint16_t> values(part.shape.count(), pruned_value);
  RankLists lists(std::max(coded.codewords, parents ? parent_codewords : 0), coded.codewords,
                  coded.ranks);
  const auto ended = walk_indices(live, first_past(part, parents), std::move(lists), values,
                                  decoder_of(coded, chunk));
  if (!ended.finished()) damaged(coded.name + ": coded indices do not end well");
  cell_order(values, part.shape, part.of(indices));
}

}  // namespace bosk
