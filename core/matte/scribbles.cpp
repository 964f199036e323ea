#include "core/matte/scribbles.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

// Paint programs and JPEG shift the three values a little; anything further off is a soft stroke
// edge.
constexpr int kValueTolerance = 24;

std::uint8_t stroke_kind(int value) {
  if (value >= 255 - kValueTolerance) return kForegroundStroke;
  if (value <= kValueTolerance) return kBackgroundStroke;
  return kNoStroke;
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

void require_shape(const Image<std::uint8_t>& drawn, const Lens& original,
                   const std::string& file) {
  const double drawn_slope = double(drawn.height()) / std::max(1, drawn.width());
  const double photo_slope = double(original.height_px) / std::max(1, original.width_px);
  const double rounding = 1.0 / std::max(1, std::min(drawn.width(), drawn.height()));
  if (!drawn.empty() && std::abs(drawn_slope / photo_slope - 1.0) <= 0.01 + rounding) return;
  throw Error(file + ": is " + size_text(drawn.width(), drawn.height()) + " pixels, its photo " +
              size_text(original.width_px, original.height_px) +
              "; draw the strokes over the photo as it was taken");
}

}  // namespace

bool has_kind(const Image<std::uint8_t>& strokes, std::uint8_t kind) {
  return std::find(strokes.pixels().begin(), strokes.pixels().end(), kind) !=
         strokes.pixels().end();
}

bool has_both_kinds(const Image<std::uint8_t>& strokes) {
  return has_kind(strokes, kForegroundStroke) && has_kind(strokes, kBackgroundStroke);
}

void require_both_kinds(const Image<std::uint8_t>& strokes, const std::string& file) {
  const bool foreground = has_kind(strokes, kForegroundStroke);
  const bool background = has_kind(strokes, kBackgroundStroke);
  if (foreground && background) return;
  if (!foreground && !background) {
    throw Error(
        file +
        ": has no strokes; draw white over the tree and black over the background on grey 128");
  }
  throw Error(file + (foreground
                          ? ": has no strokes over the background (black in a file); draw some"
                          : ": has no strokes over the tree (white in a file); draw some"));
}

Image<std::uint8_t> drawing_in_photo(const Image<std::uint8_t>& drawn, const Photo& photo,
                                     const std::string& file) {
  const Lens& original = photo.original_camera.lens;
  require_shape(drawn, original, file);
  const Lens drawn_lens = scaled(original, drawn.width(), drawn.height());
  const Lens& working = photo.camera.lens;
  Image<std::uint8_t> strokes(working.width_px, working.height_px, kNoStroke);
  for (int y = 0; y < strokes.height(); ++y) {
    for (int x = 0; x < strokes.width(); ++x) {
      const glm::dvec3 direction((glm::dvec2(x, y) - working.principal_px) / working.focal_px, 1.0);
      const auto source = pixel_from_camera(drawn_lens, direction);
      if (!source) continue;
      const double u = std::round(source->x), v = std::round(source->y);
      if (u < 0 || v < 0 || u >= drawn.width() || v >= drawn.height()) continue;
      strokes(x, y) = stroke_kind(drawn(int(u), int(v)));
    }
  }
  return strokes;
}

}  // namespace bosk
