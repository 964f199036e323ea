// Dear ImGui's panels through OpenGL, without a window.

#include "ui/gl_overlay.h"

#include <gtest/gtest.h>

#include <memory>

#include "core/base/error.h"
#include "tests/ui/workstation/gl_screen.h"
#include "tests/ui/workstation/hand.h"
#include "ui/widgets/theme.h"

namespace bosk {
namespace {

std::size_t bright_pixels(const Image<glm::u8vec3>& picture) {
  std::size_t count = 0;
  for (const glm::u8vec3& pixel : picture.pixels()) count += pixel.g > 160 ? 1 : 0;
  return count;
}

TEST(OverlayGl, PanelsAreDrawnAfterEveryChangeOfSize) {
  std::unique_ptr<GlScreen> screen;
  try {
    screen = std::make_unique<GlScreen>(760, 480);
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  Hand hand(ImVec2(760, 480), "", screen->screen());
  hand.frame(3);
  const Image<glm::u8vec3> usual = screen->picture();
  ASSERT_GT(bright_pixels(usual), 100u) << "letters";
  for (const float scale : {1.5f, 0.75f, 1.0f}) {
    apply_theme(scale);
    restart_gl_overlay();
    hand.frame(3);
    EXPECT_GT(bright_pixels(screen->picture()), 100u) << scale;
    EXPECT_EQ(screen->picture() == usual, scale == 1.0f) << scale;
  }
}

}  // namespace
}  // namespace bosk
