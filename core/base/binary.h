#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/error.h"

namespace bosk {

// Plain bytes of results, for the stage cache: same machine family, same version, little-endian.
// Not an exchange format. A stage's result has, beside its declaration,
//   void write(BinaryWriter&, const Result&)   and   Result read_result(BinaryReader&).
class BinaryWriter {
 public:
  template <class T>
  void value(const T& item) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&item, sizeof(T));
  }
  template <class T>
  void array(const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(std::uint64_t(items.size()));
    append(items.data(), items.size() * sizeof(T));
  }
  void text(const std::string& characters) {
    value(std::uint64_t(characters.size()));
    append(characters.data(), characters.size());
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::byte> bytes_;
};

// Reads what BinaryWriter wrote, in the same order. Throws Error when the bytes run out or a count
// is larger than what is left.
class BinaryReader {
 public:
  explicit BinaryReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  T value() {
    static_assert(std::is_trivially_copyable_v<T>);
    T item;
    take(&item, sizeof(T));
    return item;
  }
  template <class T>
  std::vector<T> array() {
    const auto count = value<std::uint64_t>();
    if (count > bytes_.size() / sizeof(T)) throw Error("stored result is cut short");
    std::vector<T> items(count);
    take(items.data(), count * sizeof(T));
    return items;
  }
  std::string text() {
    const auto characters = array<char>();
    return {characters.begin(), characters.end()};
  }
  bool at_end() const { return bytes_.empty(); }

 private:
  void take(void* target, std::size_t size) {
    if (size > bytes_.size()) throw Error("stored result is cut short");
    if (size > 0) std::memcpy(target, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  std::span<const std::byte> bytes_;
};

}  // namespace bosk
