#pragma once

#include <cstdint>

#include "core/image/image.h"
#include "core/phantom/phantom.h"

namespace bosk {

// Strokes as a patient user draws them with a thin brush: 255 tree, 0 background, 128 unknown.
// Strokes on the tree wander through its closed parts, along the trunk too, and keep to pixels of
// at least 0.95 opacity; strokes on the background keep clear of the tree by a pixel or two.
Image<std::uint8_t> draw_scribbles(const PhantomView& view, std::uint64_t seed);

}  // namespace bosk
