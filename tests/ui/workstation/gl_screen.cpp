#include "tests/ui/workstation/gl_screen.h"

#include <GL/glcorearb.h>

#include <cmath>

#include "core/render/gl/headless_context.h"
#include "core/render/gl/offscreen_target.h"
#include "ui/gl_overlay.h"
#include "ui/gl_pictures.h"

namespace bosk {

struct GlScreen::Parts {
  Parts(int width_px, int height_px) : target(width_px, height_px) {}

  HeadlessContext context;
  OffscreenTarget target;
  bool started = false;
};

GlScreen::GlScreen(int width_px, int height_px)
    : parts_(std::make_unique<Parts>(width_px, height_px)) {}
GlScreen::~GlScreen() = default;

HandScreen GlScreen::screen() {
  HandScreen screen;
  screen.device = gl_picture_device();
  screen.begin_frame = [this] {
    if (!parts_->started) start_gl_overlay();
    parts_->started = true;
    begin_gl_overlay();
  };
  screen.end_frame = [this] {
    parts_->target.bind();
    parts_->target.clear({0.0f, 0.0f, 0.0f, 1.0f});
    draw_gl_overlay();
  };
  screen.close = [] { stop_gl_overlay(); };
  return screen;
}

Image<glm::u8vec3> GlScreen::picture() const {
  const Image<glm::vec4> drawn = parts_->target.read();
  Image<glm::u8vec3> picture(drawn.width(), drawn.height());
  for (std::size_t i = 0; i < drawn.pixels().size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const float value = glm::clamp(drawn.pixels()[i][channel], 0.0f, 1.0f);
      picture.pixels()[i][channel] = std::uint8_t(std::lround(255.0f * value));
    }
  }
  return picture;
}

}  // namespace bosk
