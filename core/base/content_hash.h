#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct XXH3_state_s;

namespace bosk {

// Fingerprint of content (XXH3, 128 bit): equal content, equal hash. Guards against accidents, not
// against an attacker who makes collisions on purpose.
struct ContentHash {
  std::uint64_t high = 0, low = 0;

  auto operator<=>(const ContentHash&) const = default;
};

// 32 lower-case hexadecimal digits, high half first.
std::string hex(const ContentHash& hash);

// Takes content piece by piece. Text and arrays count with their length, so that "ab", "c" differs
// from "a", "bc"; `bytes` counts without, so that a file may come in chunks.
class ContentHasher {
 public:
  ContentHasher();

  ContentHasher& bytes(std::span<const std::byte> piece);
  ContentHasher& text(std::string_view characters);
  template <class T>
  ContentHasher& value(const T& item) {
    // Padding has no defined content; hash the members of such a type one by one
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
    return bytes(std::as_bytes(std::span(&item, 1)));
  }
  template <class T>
  ContentHasher& array(const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(std::uint64_t(items.size()));
    return bytes(std::as_bytes(std::span(items)));
  }
  ContentHash finish() const;

 private:
  struct FreeState {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, FreeState> state_;
};

ContentHash content_hash(std::span<const std::byte> bytes);

}  // namespace bosk
