#include "core/base/content_hash.h"

#include <xxhash.h>

#include <new>

namespace bosk {

std::string hex(const ContentHash& hash) {
  std::string digits(32, '0');
  for (int i = 0; i < 32; ++i) {
    const std::uint64_t half = i < 16 ? hash.high : hash.low;
    digits[std::size_t(i)] = "0123456789abcdef"[(half >> (60 - 4 * (i % 16))) & 15];
  }
  return digits;
}

void ContentHasher::FreeState::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

ContentHasher::ContentHasher() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_128bits_reset(state_.get());
}

ContentHasher& ContentHasher::bytes(std::span<const std::byte> piece) {
  XXH3_128bits_update(state_.get(), piece.data(), piece.size());
  return *this;
}

ContentHasher& ContentHasher::text(std::string_view characters) {
  value(std::uint64_t(characters.size()));
  return bytes(std::as_bytes(std::span(characters.data(), characters.size())));
}

ContentHash ContentHasher::finish() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
  return {hash.high64, hash.low64};
}

ContentHash content_hash(std::span<const std::byte> bytes) {
  return ContentHasher().bytes(bytes).finish();
}

}  // namespace bosk
