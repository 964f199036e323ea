#pragma once

#include <memory>

#include "core/image/image.h"
#include "tests/ui/workstation/hand.h"

namespace bosk {

// Draws what a Hand sees with OpenGL, into a picture without a window. Must outlive the Hand.
class GlScreen {
 public:
  // Throws Error where there is no OpenGL 4.5.
  GlScreen(int width_px, int height_px);
  ~GlScreen();
  GlScreen(const GlScreen&) = delete;
  GlScreen& operator=(const GlScreen&) = delete;

  HandScreen screen();
  // The newest frame, opaque.
  Image<glm::u8vec3> picture() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bosk
