#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"
#include "core/render/gl/gl_object.h"

namespace bosk {

// A picture to draw into without a window: floating-point colour, 32-bit floating-point depth. A
// size of zero is drawn to and read as an empty picture.
class OffscreenTarget {
 public:
  // Bits of a colour channel. 16 serve a screen; every billboard is rounded to them, and what is
  // fainter than a 2000th of what lies behind it is lost.
  enum class Precision { bits_16, bits_32 };
  // Throws Error when the driver cannot hold a picture so large.
  OffscreenTarget(int width_px, int height_px, Precision precision = Precision::bits_16);

  // Makes it the framebuffer that is drawn to, and its whole the viewport.
  void bind() const;
  void clear(const glm::vec4& colour) const;
  // What was drawn, top row first, channels as they are.
  Image<glm::vec4> read() const;

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  unsigned framebuffer() const { return framebuffer_.name(); }
  unsigned colour_texture() const { return colour_.name(); }

 private:
  int width_px_, height_px_;
  GlObject colour_, depth_, framebuffer_;
};

}  // namespace bosk
