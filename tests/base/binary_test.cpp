#include "core/base/binary.h"

#include <gtest/gtest.h>

namespace bosk {
namespace {

BinaryWriter sample() {
  BinaryWriter writer;
  writer.value(7);
  writer.array(std::vector<double>{1.5, -2.5});
  writer.text("leaf");
  return writer;
}

TEST(Binary, ReadsBackWhatWasWritten) {
  const BinaryWriter writer = sample();
  BinaryReader reader(writer.bytes());
  EXPECT_EQ(reader.value<int>(), 7);
  EXPECT_EQ(reader.array<double>(), (std::vector<double>{1.5, -2.5}));
  EXPECT_EQ(reader.text(), "leaf");
  EXPECT_TRUE(reader.at_end());
}

TEST(Binary, RefusesEveryCutLength) {
  const BinaryWriter writer = sample();
  const std::span<const std::byte> whole = writer.bytes();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read_all = [&] {
      BinaryReader reader(whole.first(size));
      reader.value<int>();
      reader.array<double>();
      reader.text();
    };
    EXPECT_THROW(read_all(), Error) << size;
  }
}

TEST(Binary, RefusesACountThatCannotBe) {
  BinaryWriter writer;
  writer.value(~std::uint64_t(0));
  BinaryReader reader(writer.bytes());
  EXPECT_THROW(reader.array<double>(), Error);
}

}  // namespace
}  // namespace bosk
