#include "core/package/near_codewords.h"

#include <algorithm>
#include <cstdlib>

namespace bosk {
namespace {

constexpr std::uint32_t kWindow = 512;
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

template <int kBytes>
Key distance(const std::uint8_t* a, const std::uint8_t* b) {
  int sum = 0;
  for (int i = 0; i < kBytes; ++i) sum += std::abs(a[i] - b[i]);
  return Key(sum);
}

template <int kBytes>
NearCodewords nearest(const std::vector<std::uint8_t>& texels, std::uint32_t count,
                      std::uint32_t length) {
  NearCodewords near{count, std::min(length, count), {}};
  near.lists.resize(std::size_t(count) * near.length);
  std::vector<Key> keys;
  for (std::uint32_t codeword = 0; codeword < count; ++codeword) {
    const std::uint32_t first = codeword > kWindow ? codeword - kWindow : 0;
    const std::uint32_t last = std::min(count, codeword + kWindow + 1);
    keys.resize(last - first);
    const std::uint8_t* own = texels.data() + std::size_t(codeword) * kBytes;
    for (std::uint32_t other = first; other < last; ++other) {
      keys[other - first] = distance<kBytes>(own, texels.data() + std::size_t(other) * kBytes)
                                << 16 |
                            (other - first);
    }
    const auto used = std::min<std::size_t>(near.length, keys.size());
    std::partial_sort(keys.begin(), keys.begin() + std::ptrdiff_t(used), keys.end());
    std::uint16_t* list = near.lists.data() + std::size_t(codeword) * near.length;
    for (std::size_t rank = 0; rank < used; ++rank) {
      list[rank] = std::uint16_t(first + (keys[rank] & 0xffff));
    }
  }
  return near;
}

}  // namespace

NearCodewords near_codewords(const CodeAtlas& atlas, const CodeRange& codes, CodewordKind kind,
                             std::uint32_t length) {
  if (kind == CodewordKind::alpha) {
    return nearest<16>(codeword_texels(atlas, codes, 3, 1), codes.count, length);
  }
  return nearest<48>(codeword_texels(atlas, codes, 0, 3), codes.count, length);
}

}  // namespace bosk
