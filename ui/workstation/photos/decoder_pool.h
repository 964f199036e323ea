#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/photo/decode.h"

namespace bosk {

// Decoders that go from job to job, whatever threads those run on: starting one costs 0.2 s.
class DecoderPool {
 public:
  // Runs `use` with a decoder that nobody else has meanwhile.
  template <class Use>
  auto with_decoder(const DecodeLimits& limits, const Use& use) {
    Kept kept = taken(limits);
    auto result = use(*kept.decoder);
    // One that threw is left to end with its child
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(kept));
    return result;
  }

 private:
  struct Kept {
    DecodeLimits limits;
    std::unique_ptr<PhotoDecoder> decoder;
  };
  static bool is_same(const DecodeLimits& a, const DecodeLimits& b) {
    return a.max_megapixels == b.max_megapixels && a.child.memory_bytes == b.child.memory_bytes &&
           a.child.wall_s == b.child.wall_s;
  }
  Kept taken(const DecodeLimits& limits) {
    const std::lock_guard lock(mutex_);
    std::erase_if(free_, [&](const Kept& kept) { return !is_same(kept.limits, limits); });
    if (free_.empty()) return {limits, std::make_unique<PhotoDecoder>(limits)};
    Kept kept = std::move(free_.back());
    free_.pop_back();
    return kept;
  }

  std::mutex mutex_;
  std::vector<Kept> free_;
};

}  // namespace bosk
