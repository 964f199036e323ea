#include "core/package/index_decode.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/package/byte_cursor.h"

namespace bosk {
namespace {

// Which symbol a slot of a context's 2^12 belongs to.
struct Slot {
  std::uint32_t frequency_less_one : 12 = 0, offset : 12 = 0, symbol : 8 = 0;
};

struct RankedTables {
  std::array<std::uint16_t, kFlagContexts> pruned{};  // frequency of "pruned" out of 2^12
  std::vector<Slot> slots;                            // [context][2^12]
};

// Duda's asymmetric numeral systems, range variant, two states in turn so that a processor can work
// on both. No branch depends on the data. Words beyond the end read as 0 and are told by
// `finished`.
class RansDecoder {
 public:
  // `words` must have one word behind them that may be read, and outlive the decoder; as the tables
  // must.
  RansDecoder(std::span<const std::uint16_t> words, const RankedTables& tables)
      : next_(words.data()),
        end_(words.data() + words.size()),
        pruned_(tables.pruned.data()),
        slots_(tables.slots.data()) {
    state_ = start();
    other_ = start();
  }
  bool flag(unsigned context) {
    const std::uint32_t pruned = pruned_[context], low = state_ & (kProbabilityOne - 1);
    const bool is_live = low >= pruned;
    advance(is_live ? kProbabilityOne - pruned : pruned, is_live ? low - pruned : low);
    return is_live;
  }
  unsigned token(unsigned context) {
    const Slot slot = slots_[context << kProbabilityBits | (state_ & (kProbabilityOne - 1))];
    advance(slot.frequency_less_one + 1, slot.offset);
    return slot.symbol;
  }
  // The coder began with both states at the lower end, so a sound stream ends there.
  bool finished() const { return next_ == end_ && state_ == kRansLow && other_ == kRansLow; }

 private:
  void advance(std::uint32_t frequency, std::uint32_t offset) {
    const std::uint32_t state = frequency * (state_ >> kProbabilityBits) + offset;
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
  const Slot* slots_;
  std::uint32_t state_ = 0, other_ = 0;
};

// Bits, lowest first; beyond the end they are 0 and told by `finished`.
class BitReader {
 public:
  explicit BitReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint32_t bits(unsigned count) {  // at most 24
    while (held_ < count) {
      const auto byte = next_ < bytes_.size() ? std::uint64_t(bytes_[next_]) : 0;
      buffer_ |= byte << held_;
      held_ += 8;
      ++next_;
    }
    const auto taken = std::uint32_t(buffer_ & ((std::uint64_t(1) << count) - 1));
    buffer_ >>= count;
    held_ -= count;
    return taken;
  }
  bool finished() const { return next_ == bytes_.size() && buffer_ == 0; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t next_ = 0;
  std::uint64_t buffer_ = 0;
  unsigned held_ = 0;
};

class RankedDecoder {
 public:
  RankedDecoder(RansDecoder rans, BitReader bits, const NearCodewords& near,
                const std::string& name)
      : rans_(rans),
        bits_(bits),
        lists_(near.lists.data()),
        length_(near.length),
        count_(near.count),
        name_(&name) {}

  bool flag(unsigned context, bool) { return rans_.flag(context); }
  std::uint16_t index(unsigned context, std::uint16_t expected, std::uint16_t) {
    const unsigned token = rans_.token(context);
    if (token < length_) return lists_[std::size_t(expected) * length_ + token];
    return escaped(token - length_, expected);
  }
  void expect_end() const {
    if (!rans_.finished() || !bits_.finished()) damaged(*name_ + ": coded indices do not end well");
  }

 private:
  // `bit_count` bits of zigzag difference, of which the highest is 1 and not stored.
  std::uint16_t escaped(unsigned bit_count, std::uint16_t expected) {
    if (bit_count >= kEscapeTokens) damaged(*name_ + ": unknown token");
    const std::uint32_t zigzag =
        bit_count < 2 ? bit_count : 1u << (bit_count - 1) | bits_.bits(bit_count - 1);
    const std::int32_t half = std::int32_t(zigzag >> 1);
    const std::int32_t index = std::int32_t(expected) + ((zigzag & 1) != 0 ? -half - 1 : half);
    if (index < 0 || index >= std::int32_t(count_)) damaged(*name_ + ": index beyond the codebook");
    return std::uint16_t(index);
  }

  RansDecoder rans_;
  BitReader bits_;
  const std::uint16_t* lists_;
  std::uint32_t length_, count_;
  const std::string* name_;
};

void read_context(ByteCursor& cursor, std::span<Slot> slots) {
  const unsigned symbols = cursor.value<std::uint8_t>();
  std::size_t filled = 0;
  for (unsigned symbol = 0; symbol < symbols; ++symbol) {
    const std::uint64_t frequency = cursor.varint();
    if (frequency > slots.size() - filled) damaged(cursor.section() + ": frequencies");
    for (std::uint32_t offset = 0; offset < frequency; ++offset) {
      slots[filled++] = {std::uint32_t(frequency - 1) & 0xfff, offset & 0xfff, symbol & 0xff};
    }
  }
  if (symbols != 0 && filled != slots.size()) damaged(cursor.section() + ": frequencies");
}

RankedTables read_tables(ByteCursor& cursor, bool with_flags, unsigned contexts) {
  RankedTables tables;
  if (with_flags) {
    for (auto& frequency : tables.pruned) {
      frequency = cursor.value<std::uint16_t>();
      if (frequency == 0 || frequency >= kProbabilityOne)
        damaged(cursor.section() + ": frequencies");
    }
  }
  tables.slots.resize(std::size_t(contexts) << kProbabilityBits);
  for (unsigned context = 0; context < contexts; ++context) {
    read_context(
        cursor,
        std::span(tables.slots).subspan(std::size_t(context) << kProbabilityBits, kProbabilityOne));
  }
  return tables;
}

std::vector<std::uint16_t> decode_planes(ByteCursor& cursor, const IndexShape& shape) {
  const auto low = cursor.take(shape.count()), high = cursor.take(shape.count());
  cursor.expect_end();
  std::vector<std::uint16_t> values(shape.count());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = std::uint16_t(unsigned(low[i]) | unsigned(high[i]) << 8);
  }
  return values;
}

// Either kind; `alpha` is null when the alpha indices themselves are decoded.
std::vector<std::uint16_t> decode_ranked(ByteCursor& cursor, const IndexShape& shape,
                                         const CodeAtlas& atlas, const CodeRange& codes,
                                         const std::span<const std::uint16_t>* alpha) {
  const unsigned length = cursor.value<std::uint8_t>(), buckets = cursor.value<std::uint8_t>();
  if (cursor.value<std::uint8_t>() != 0 || length < 1 || length > kMaxNear || buckets < 1 ||
      buckets > kMaxBuckets || codes.count == 0) {
    damaged(cursor.section() + ": parameters of the index coding");
  }
  const auto word_count = cursor.value<std::uint32_t>(), bit_bytes = cursor.value<std::uint32_t>();
  const RankedTables tables = read_tables(cursor, alpha == nullptr, buckets + 1);
  auto words = cursor.array<std::uint16_t>(word_count);
  const auto bits = cursor.take(bit_bytes);
  cursor.expect_end();
  words.push_back(0);
  const auto near =
      near_codewords(atlas, codes, alpha ? CodewordKind::colour : CodewordKind::alpha, length);
  const RansDecoder rans(std::span<const std::uint16_t>(words).first(word_count), tables);
  const RankedDecoder decoder(rans, BitReader{bits}, near, cursor.section());
  const IndexPredictor predictor(shape, codes.count, buckets);
  std::vector<std::uint16_t> values(shape.count(), 0);
  const auto ended = alpha ? walk_colour(shape, predictor, *alpha, values, decoder)
                           : walk_alpha(shape, predictor, values, decoder);
  ended.expect_end();
  return values;
}

// Indices in view order.
std::vector<std::uint16_t> decode(std::span<const std::byte> bytes, const IndexShape& shape,
                                  const CodeAtlas& atlas, const CodeRange& codes,
                                  const std::span<const std::uint16_t>* alpha,
                                  const std::string& name) {
  ByteCursor cursor(bytes, name);
  const auto transform = IndexTransform(cursor.value<std::uint8_t>());
  if (transform == IndexTransform::planes) return decode_planes(cursor, shape);
  if (transform != IndexTransform::ranked) damaged(name + ": unknown coding of indices");
  return decode_ranked(cursor, shape, atlas, codes, alpha);
}

}  // namespace

LevelIndices decode_level_indices(std::span<const std::byte> alpha_bytes,
                                  std::span<const std::byte> colour_bytes, const IndexShape& shape,
                                  const CodeAtlas& atlas, const TreeLevel& frame) {
  const std::string name = " indices of level " + std::to_string(frame.level);
  const auto alpha = decode(alpha_bytes, shape, atlas, frame.alpha_codes, nullptr, "alpha" + name);
  const std::span<const std::uint16_t> known_alpha(alpha);
  const auto colour =
      decode(colour_bytes, shape, atlas, frame.colour_codes, &known_alpha, "colour" + name);
  return {cell_order(alpha, shape), cell_order(colour, shape)};
}

}  // namespace bosk
