#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace bosk {

// Puts little-endian values one behind the other: the other end of ByteCursor.
struct ByteSink {
  std::vector<std::byte> bytes;

  template <class T>
  void value(T item) {
    static_assert(std::is_arithmetic_v<T>);
    append(std::as_bytes(std::span(&item, 1)));
  }
  void append(std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  void varint(std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) value(std::uint8_t(number | 0x80));
    value(std::uint8_t(number));
  }
};

}  // namespace bosk
