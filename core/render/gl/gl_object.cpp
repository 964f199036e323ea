#include "core/render/gl/gl_object.h"

#include <GL/glcorearb.h>

#include <algorithm>
#include <cassert>
#include <string>

#include "core/base/error.h"

namespace bosk {
namespace {

const std::string kRemedy = "; install a driver (Debian: libgl1-mesa-dri) or draw without OpenGL";

}  // namespace

GlObject::GlObject(Kind kind) : kind_(kind) {
  switch (kind) {
    case Kind::none:
      break;
    case Kind::buffer:
      glCreateBuffers(1, &name_);
      break;
    case Kind::texture_2d:
      glCreateTextures(GL_TEXTURE_2D, 1, &name_);
      break;
    case Kind::texture_array:
      glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name_);
      break;
    case Kind::program:
      name_ = glCreateProgram();
      break;
    case Kind::framebuffer:
      glCreateFramebuffers(1, &name_);
      break;
    case Kind::vertex_array:
      glCreateVertexArrays(1, &name_);
      break;
  }
}

GlObject::~GlObject() {
  switch (kind_) {
    case Kind::none:
      break;
    case Kind::buffer:
      glDeleteBuffers(1, &name_);
      break;
    case Kind::texture_2d:
    case Kind::texture_array:
      glDeleteTextures(1, &name_);
      break;
    case Kind::program:
      glDeleteProgram(name_);
      break;
    case Kind::framebuffer:
      glDeleteFramebuffers(1, &name_);
      break;
    case Kind::vertex_array:
      glDeleteVertexArrays(1, &name_);
      break;
  }
}

FixedBuffer make_buffer(std::span<const std::byte> data) {
  FixedBuffer buffer{GlObject(GlObject::Kind::buffer), std::max<std::size_t>(data.size(), 4)};
  glNamedBufferStorage(buffer.object.name(), GLsizeiptr(buffer.bytes),
                       data.empty() ? nullptr : data.data(), 0);
  return buffer;
}

void StreamBuffer::write(std::span<const std::byte> data) {
  reserve(data.size());
  glInvalidateBufferData(object_.name());
  if (!data.empty()) glNamedBufferSubData(object_.name(), 0, GLsizeiptr(data.size()), data.data());
}

void StreamBuffer::reserve(std::size_t bytes) {
  if (object_ && bytes <= bytes_) return;
  if (!object_) object_ = GlObject(GlObject::Kind::buffer);
  bytes_ = std::max({bytes, bytes_ + bytes_ / 2, std::size_t(256)});
  glNamedBufferData(object_.name(), GLsizeiptr(bytes_), nullptr, GL_DYNAMIC_DRAW);
}

std::string driver_description() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value ? std::string(reinterpret_cast<const char*>(value)) : std::string();
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void require_gl_context() {
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  if (!version) throw Error("no OpenGL context is current" + kRemedy);
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 45)
    throw Error("OpenGL here is version " + std::string(version) + ", drawing needs 4.5" + kRemedy);
  if (glGetGraphicsResetStatus() != GL_NO_ERROR)
    throw Error("the graphics driver was reset and lost its content; start again",
                ErrorKind::temporary);
}

void check_gl(const char* doing) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  if (error == GL_OUT_OF_MEMORY)
    throw Error(std::string(doing) +
                    ": the graphics card has not enough memory; close other "
                    "programs or draw fewer or smaller trees",
                ErrorKind::resource);
  throw Error(std::string(doing) + ": OpenGL reports error " + std::to_string(error) + kRemedy,
              ErrorKind::temporary);
}

}  // namespace bosk
