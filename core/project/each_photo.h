#pragma once

#include <cstddef>
#include <functional>

#include "core/base/progress.h"
#include "core/photo/decode.h"

namespace bosk {

// Calls `work` for photo 0 to count - 1, a few at a time, each with a decoder of its thread's own,
// and counts each in the step that `progress` is in. An Error ends it all; throws Cancelled.
void for_each_photo(std::size_t count, const DecodeLimits& limits, Progress& progress,
                    const std::function<void(std::size_t, PhotoDecoder&)>& work);

}  // namespace bosk
