#include "core/render/gl/headless_context.h"

#include <GL/glcorearb.h>

#include <cstdio>
#include <cstdlib>

#include "core/render/gl/program.h"
#include "tests/render/gl/gl_test.h"

namespace bosk {
namespace {

using HeadlessContextTest = GlTest;

// In a process of its own: a driver once loaded stays.
[[noreturn]] void start_without_driver() {
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere", 1);
  try {
    const HeadlessContext context;
  } catch (const Error& error) {
    std::fputs(error.what(), stderr);
    std::exit(3);
  }
  std::exit(0);
}

TEST(HeadlessContextDeathTest, SaysWhatToInstallWhereThereIsNoDriver) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(start_without_driver(), testing::ExitedWithCode(3),
              "libgl1-mesa-dri.*render without --gl");
}

TEST_F(HeadlessContextTest, CollectsWhatTheDriverComplainsOf) {
  HeadlessContext context(true);
  EXPECT_TRUE(context.errors().empty());
  EXPECT_NE(context.description().find("OpenGL"), std::string::npos);
  glEnable(0xffff);
  EXPECT_EQ(context.errors().size(), 1u);
}

TEST_F(HeadlessContextTest, HoldsPicturesWithTheTopRowFirst) {
  const OffscreenTarget target(3, 2);
  target.bind();
  target.clear({0.25f, 0.5f, 0.75f, 1.0f});
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 1, 3, 1);  // OpenGL's upper row
  target.clear(glm::vec4(0.0f));
  glDisable(GL_SCISSOR_TEST);
  const Image<glm::vec4> image = target.read();
  EXPECT_EQ(image(1, 0), glm::vec4(0.0f));
  EXPECT_EQ(image(1, 1), glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
}

TEST_F(HeadlessContextTest, RefusesPicturesThatTheDriverCannotHold) {
  EXPECT_THROW(OffscreenTarget(1'000'000, 10), Error);
}

TEST_F(HeadlessContextTest, EveryShaderIsInTheProgram) {
  EXPECT_GE(shader_texts().size(), 8u);
  for (const ShaderText& shader : shader_texts()) EXPECT_GT(std::string(shader.text).size(), 20u);
}

}  // namespace
}  // namespace bosk
