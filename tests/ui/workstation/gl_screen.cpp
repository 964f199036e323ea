#include "tests/ui/workstation/gl_screen.h"

#include <GL/glcorearb.h>
#include <backends/imgui_impl_opengl3.h>

#include <cmath>

#include "core/render/gl/headless_context.h"
#include "core/render/gl/offscreen_target.h"
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
    if (!parts_->started) ImGui_ImplOpenGL3_Init("#version 450");
    parts_->started = true;
    ImGui_ImplOpenGL3_NewFrame();
  };
  screen.end_frame = [this] {
    parts_->target.bind();
    parts_->target.clear({0.0f, 0.0f, 0.0f, 1.0f});
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  };
  screen.close = [] { ImGui_ImplOpenGL3_Shutdown(); };
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
