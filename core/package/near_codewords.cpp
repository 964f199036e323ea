#include "core/package/near_codewords.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace bosk {
namespace {

constexpr std::uint32_t kWindow = 512;
constexpr std::size_t kMaxFew = 128;
using Key = std::uint32_t;  // distance in the high half, codeword's place in the window in the low

// Texel bytes of each codeword side by side: 16 alpha values, or 16 x rgb.
std::vector<std::uint8_t> codeword_texels(const CodeAtlas& atlas, const CodeRange& codes,
                                          int channel, int channels) {
  std::vector<std::uint8_t> texels;
  texels.reserve(std::size_t(codes.count) * 16 * std::size_t(channels));
  const int tiles_across = atlas.width_px / 4;
  for (std::uint32_t tile = codes.first; tile < codes.first + codes.count; ++tile) {
    const int left = int(tile) % tiles_across * 4, top = int(tile) / tiles_across * 4;
    for (int t = 0; t < 16; ++t) {
      const auto& texel = atlas.rgba[std::size_t((top + t / 4) * atlas.width_px + left + t % 4)];
      for (int c = channel; c < channel + channels; ++c) texels.push_back(texel[c]);
    }
  }
  return texels;
}

// `bytes` is 16 or 48, but not a constant: unrolled, compilers miss the sum-of-differences
// instruction.
std::uint16_t distance(const std::uint8_t* a, const std::uint8_t* b, int bytes) {
  int sum = 0;
  for (int i = 0; i < bytes; ++i) sum += std::abs(a[i] - b[i]);
  return std::uint16_t(sum);
}

std::uint32_t count_up_to(std::span<const std::uint16_t> distances, std::uint16_t limit) {
  std::uint16_t count = 0;  // as narrow as the distances: eight a vector instruction
  for (const std::uint16_t d : distances) count = std::uint16_t(count + (d <= limit));
  return count;
}

// A distance that at least `wanted` of them do not exceed, and few more than that where ties allow.
// By bisection: reading 1025 numbers some ten times is faster here than sorting them in part.
std::uint16_t limit_of(std::span<const std::uint16_t> distances, std::uint32_t wanted) {
  constexpr std::uint32_t kFewMore = 16;
  unsigned low = 0, high = 48 * 255;
  while (low < high) {
    const unsigned middle = (low + high) / 2;
    const std::uint32_t count = count_up_to(distances, std::uint16_t(middle));
    if (count >= wanted && count <= wanted + kFewMore) return std::uint16_t(middle);
    if (count >= wanted) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::uint16_t(low);
}

// Sorts a few distinct numbers: each goes where the count of smaller ones says. No branch to
// mispredict, and compilers vectorise the counting.
void sort_few(std::span<Key> keys) {
  std::array<Key, kMaxFew> sorted;
  for (const Key key : keys) {
    std::int32_t place = 0;
    for (const Key other : keys) place += std::int32_t(other) < std::int32_t(key);
    sorted[std::size_t(place)] = key;
  }
  std::copy_n(sorted.begin(), keys.size(), keys.begin());
}

// The `list.size()` smallest, in order; `first` is the number of the first candidate.
void select_nearest(std::span<const std::uint16_t> distances, std::uint32_t first,
                    std::vector<Key>& keys, std::span<std::uint16_t> list) {
  const std::uint16_t limit = limit_of(distances, std::uint32_t(list.size()));
  keys.resize(distances.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    keys[kept] = Key(distances[i]) << 16 | Key(i);
    kept += distances[i] <= limit;
  }
  if (kept <= kMaxFew) {
    sort_few(std::span(keys).first(kept));
  } else {
    std::sort(keys.begin(), keys.begin() + std::ptrdiff_t(kept));
  }
  for (std::size_t rank = 0; rank < list.size(); ++rank) {
    list[rank] = std::uint16_t(first + (keys[rank] & 0xffff));
  }
}

NearCodewords nearest(const std::vector<std::uint8_t>& texels, int bytes, std::uint32_t count,
                      std::uint32_t length) {
  NearCodewords near{count, std::min(length, count), {}};
  near.lists.resize(std::size_t(count) * near.length);
  std::vector<std::uint16_t> distances;
  std::vector<Key> keys;
  for (std::uint32_t codeword = 0; codeword < count; ++codeword) {
    const std::uint32_t first = codeword > kWindow ? codeword - kWindow : 0;
    const std::uint32_t last = std::min(count, codeword + kWindow + 1);
    distances.resize(last - first);
    const std::uint8_t* own = texels.data() + std::size_t(codeword) * std::size_t(bytes);
    for (std::uint32_t other = first; other < last; ++other) {
      distances[other - first] =
          distance(own, texels.data() + std::size_t(other) * std::size_t(bytes), bytes);
    }
    select_nearest(distances, first, keys,
                   std::span(near.lists).subspan(std::size_t(codeword) * near.length, near.length));
  }
  return near;
}

}  // namespace

NearCodewords near_codewords(const CodeAtlas& atlas, const CodeRange& codes, CodewordKind kind,
                             std::uint32_t length) {
  const int channels = kind == CodewordKind::alpha ? 1 : 3,
            first = kind == CodewordKind::alpha ? 3 : 0;
  return nearest(codeword_texels(atlas, codes, first, channels), 16 * channels, codes.count,
                 length);
}

}  // namespace bosk
