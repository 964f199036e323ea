#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/package/atlas_coding.h"
#include "core/package/index_coding.h"
#include "core/package/model_check.h"
#include "core/package/near_codewords.h"
#include "tests/package/sample_tree.h"

namespace bosk {
namespace {

int distance(const CodeAtlas& atlas, std::uint32_t a, std::uint32_t b, int first, int last) {
  int sum = 0;
  for (std::size_t t = 0; t < 16; ++t) {
    for (int channel = first; channel <= last; ++channel) {
      sum += std::abs(atlas.rgba[atlas_index(atlas, a, t)][channel] -
                      atlas.rgba[atlas_index(atlas, b, t)][channel]);
    }
  }
  return sum;
}

void expect_lists_as_sorted(CodewordKind kind, int first, int last) {
  const CodeAtlas atlas = sample_tree({.levels = {}, .colour_codewords = 300}).atlas;
  const CodeRange codes{40, 250};
  const NearCodewords near = near_codewords(atlas, codes, kind, 64);
  for (std::uint32_t codeword = 0; codeword < codes.count; ++codeword) {
    std::vector<std::pair<int, std::uint16_t>> all;
    for (std::uint32_t other = 0; other < codes.count; ++other) {
      all.emplace_back(distance(atlas, codes.first + codeword, codes.first + other, first, last),
                       other);
    }
    std::sort(all.begin(), all.end());
    for (std::size_t rank = 0; rank < 64; ++rank) {
      ASSERT_EQ(near.of(codeword)[rank], all[rank].second) << codeword << " rank " << rank;
    }
  }
}

TEST(NearCodewords, ListsColoursAsSortingAllDistancesDoes) {
  expect_lists_as_sorted(CodewordKind::colour, 0, 2);
}
TEST(NearCodewords, ListsAlphasAsSortingAllDistancesDoes) {
  expect_lists_as_sorted(CodewordKind::alpha, 3, 3);
}

TEST(NearCodewords, ListsAreNoLongerThanTheCodebook) {
  const CodeAtlas atlas = sample_tree({.levels = {}}).atlas;
  EXPECT_EQ(near_codewords(atlas, {3, 5}, CodewordKind::alpha, 64).length, 5u);
  EXPECT_TRUE(near_codewords(atlas, {3, 0}, CodewordKind::alpha, 64).lists.empty());
}

TEST(IndexOrder, ViewOrderAndBackIsTheSame) {
  for (const std::size_t blocks : {1, 4}) {
    const IndexShape shape{131, 3, blocks};
    std::vector<std::uint16_t> values(shape.count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::uint16_t(i);
    const auto by_view = view_order(values, shape);
    EXPECT_EQ(by_view[blocks], values[3 * blocks]);  // second cell of the first view
    EXPECT_EQ(cell_order(by_view, shape), values);
  }
}

TEST(CleanText, IsUtf8WithoutControls) {
  for (const char* good : {"", "Eiche", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x8c\xb3", "a\tb\n"}) {
    EXPECT_TRUE(is_clean_text(good)) << good;
  }
  // Stray continuation, cut short, overlong, surrogate, beyond Unicode, escape, C1 control.
  for (const char* bad : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                          "\xf4\x90\x80\x80", "\x1b[2J", "\xc2\x9b", "\x7f", "\xff"}) {
    EXPECT_FALSE(is_clean_text(bad)) << bad;
  }
}

}  // namespace
}  // namespace bosk
