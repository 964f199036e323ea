#include "core/render/gl/offscreen_target.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <string>

#include "core/base/error.h"

namespace bosk {

OffscreenTarget::OffscreenTarget(int width_px, int height_px, Precision precision)
    : width_px_(width_px),
      height_px_(height_px),
      colour_(GlObject::Kind::texture_2d),
      depth_(GlObject::Kind::texture_2d),
      framebuffer_(GlObject::Kind::framebuffer) {
  require_gl_context();
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width_px > most || height_px > most)
    throw Error("a picture of " + std::to_string(width_px) + " x " + std::to_string(height_px) +
                " px is larger than this OpenGL draws (" + std::to_string(most) +
                " px); ask for a smaller one");
  const int width = std::max(width_px, 1), height = std::max(height_px, 1);
  const GLenum format = precision == Precision::bits_16 ? GL_RGBA16F : GL_RGBA32F;
  glTextureStorage2D(colour_.name(), 1, format, width, height);
  glTextureStorage2D(depth_.name(), 1, GL_DEPTH_COMPONENT32F, width, height);
  glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
  glNamedFramebufferTexture(framebuffer_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  check_gl("making a picture");
}

void OffscreenTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width_px_, height_px_);
}

void OffscreenTarget::clear(const glm::vec4& colour) const {
  const float far_depth = 1.0f;
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, &colour[0]);
  glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &far_depth);
}

Image<glm::vec4> OffscreenTarget::read() const {
  Image<glm::vec4> image(width_px_, height_px_);
  if (image.empty()) return image;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_px_, height_px_, GL_RGBA, GL_FLOAT, image.data());
  check_gl("reading a picture back");
  for (int y = 0; y < height_px_ / 2; ++y)  // OpenGL's first row is the lowest
    std::swap_ranges(&image(0, y), &image(0, y) + width_px_, &image(0, height_px_ - 1 - y));
  return image;
}

}  // namespace bosk
