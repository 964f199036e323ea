#include "core/base/content_hash.h"

#include <gtest/gtest.h>

#include <vector>

namespace bosk {
namespace {

TEST(ContentHash, IsXxh3OfTheBytes) {
  // XXH3 128 bit of no bytes, from the algorithm's published test vectors
  EXPECT_EQ(hex(content_hash({})), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, OfChunksEqualsThatOfTheWhole) {
  std::vector<std::byte> bytes(3000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(i * 7);
  const std::span<const std::byte> whole(bytes);
  const ContentHash chunked = ContentHasher()
                                  .bytes(whole.first(1))
                                  .bytes(whole.subspan(1, 1998))
                                  .bytes(whole.last(1001))
                                  .finish();
  EXPECT_EQ(chunked, content_hash(whole));
}

TEST(ContentHash, TellsWhereOneTextEndsAndTheNextBegins) {
  EXPECT_NE(ContentHasher().text("ab").text("c").finish(),
            ContentHasher().text("a").text("bc").finish());
  EXPECT_NE(ContentHasher().array(std::vector<int>{1}).array(std::vector<int>{}).finish(),
            ContentHasher().array(std::vector<int>{}).array(std::vector<int>{1}).finish());
}

TEST(ContentHash, ChangesWithEveryBit) {
  const ContentHash zero = ContentHasher().value(std::uint64_t(0)).finish();
  for (int bit = 0; bit < 64; ++bit) {
    EXPECT_NE(ContentHasher().value(std::uint64_t(1) << bit).finish(), zero);
  }
}

}  // namespace
}  // namespace bosk
