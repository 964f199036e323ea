#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/package/format.h"

namespace bosk {

// Takes little-endian values off the front of a section. Every count is compared with the bytes
// left before anything is allocated; throws Error when they run out.
class ByteCursor {
 public:
  ByteCursor(std::span<const std::byte> bytes, std::string section)
      : bytes_(bytes), section_(std::move(section)) {}

  template <class T>
  T value() {
    static_assert(std::is_arithmetic_v<T>);
    T item;
    std::memcpy(&item, take(sizeof(T)).data(), sizeof(T));
    return item;
  }
  template <class T>
  std::vector<T> array(std::uint64_t count) {
    static_assert(std::is_arithmetic_v<T>);
    if (count > bytes_.size() / sizeof(T)) run_out();
    std::vector<T> items(count);
    const auto source = take(count * sizeof(T));
    if (count > 0) std::memcpy(items.data(), source.data(), source.size());
    return items;
  }
  std::span<const std::byte> take(std::uint64_t size) {
    if (size > bytes_.size()) run_out();
    const auto taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }
  // Seven bits a byte, lowest first; at most ten bytes.
  std::uint64_t varint() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = value<std::uint8_t>();
      if (shift == 63 && byte > 1) break;
      number |= std::uint64_t(byte & 0x7f) << shift;
      if (byte < 0x80) return number;
    }
    damaged(section_ + ": a number is too long");
  }
  std::size_t left() const { return bytes_.size(); }
  // Call when all that was announced has been taken.
  void expect_end() const {
    if (!bytes_.empty()) damaged(section_ + ": more bytes than announced");
  }
  const std::string& section() const { return section_; }

 private:
  [[noreturn]] void run_out() const { damaged(section_ + ": fewer bytes than announced"); }

  std::span<const std::byte> bytes_;
  std::string section_;
};

}  // namespace bosk
