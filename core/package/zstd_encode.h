#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/progress.h"

namespace bosk {

// One zstd frame of level 19 that tells its content's size. Asks `progress` often enough for a
// prompt stop.
std::vector<std::byte> zstd_compress(std::span<const std::byte> raw, const Progress& progress);

}  // namespace bosk
