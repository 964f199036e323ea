#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>

#include "core/image/image.h"
#include "core/image/pixel_box.h"

namespace bosk {

// Ways to look at a matted photo.
enum class MatteView : std::uint8_t {
  photo,       // as it is
  overlay,     // the background dim and tinted
  on_black,    // the tree's own colour over black
  on_white,    // and over white
  matte,       // opacity as grey
  foreground,  // the tree's own colour where there is any, as if opaque
};
inline constexpr int kMatteViews = 6;

const char* name_of(MatteView view);   // "photo", "overlay", "on black", ...
MatteView view_after(MatteView view);  // round and round

// What a view is made of. The matte is at any size and stretched over the photo; where there is
// none, every view but those of the strokes shows the photo. Strokes have the photo's size, or none
// are shown.
struct MattedPhoto {
  const Image<glm::vec3>& srgb;        // 0 to 1
  const Image<glm::vec4>& matte;       // straight, sRGB-encoded; may be empty
  const Image<std::uint8_t>& strokes;  // values of scribbles.h; may be empty
};

// The colours of strokes on the screen: apart for the colour-blind too, and from leaves and sky.
inline constexpr glm::vec3 kForegroundStrokeSrgb{1.0f, 0.69f, 0.0f};    // amber
inline constexpr glm::vec3 kBackgroundStrokeSrgb{0.47f, 0.37f, 0.94f};  // indigo

// For the screen: opaque, sRGB, at the photo's size and as delivered (not turned upright).
Image<glm::u8vec4> picture_of(MatteView view, const MattedPhoto& parts);

// The same for a part of a picture that picture_of made: after a stroke, where it went.
void repaint(MatteView view, const MattedPhoto& parts, const PixelBox& box,
             Image<glm::u8vec4>& picture);

}  // namespace bosk
