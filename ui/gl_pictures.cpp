#include "ui/gl_pictures.h"

#include <GL/glcorearb.h>

#include <cstdint>

namespace bosk {
namespace {

ImTextureID id_of(GLuint name) {
  return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
}
GLuint name_of(ImTextureID id) { return static_cast<GLuint>(reinterpret_cast<std::intptr_t>(id)); }

ImTextureID upload(const Image<glm::u8vec4>& picture, ImTextureID old) {
  GLuint name = name_of(old);
  if (name == 0) {
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, GL_RGBA8, picture.width(), picture.height());
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(name, 0, 0, 0, picture.width(), picture.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                      picture.pixels().data());
  return id_of(name);
}

void free_texture(ImTextureID id) {
  const GLuint name = name_of(id);
  glDeleteTextures(1, &name);
}

}  // namespace

PictureDevice gl_picture_device() { return {upload, free_texture}; }

}  // namespace bosk
