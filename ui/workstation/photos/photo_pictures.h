#pragma once

#include <glm/gtc/type_precision.hpp>

#include "core/image/image.h"
#include "core/photo/decode.h"

namespace bosk {

// The photo as it is shown: upright by EXIF, at most `longest_px` along its longer side, never
// enlarged. Means over whole pixels, in linear light and weighted by alpha.
Image<glm::u8vec4> shown_photo(const DecodedPhoto& photo, int longest_px);

inline constexpr int kThumbnailPx = 320;
inline constexpr int kLargePhotoPx = 4096;  // what graphics cards take at the least

}  // namespace bosk
