#include "core/render/gl/headless_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <cstring>

#include "core/base/error.h"
#include "core/render/gl/gl_object.h"

namespace bosk {
namespace {

Error no_context(const std::string& why) {
  return Error(
      "OpenGL cannot be used without a window: " + why +
      "; install a driver (Debian: libgl1-mesa-dri libegl1); bosk render without --gl needs none");
}

bool has_extension(const char* list, const char* name) {
  return list && std::strstr(list, name) != nullptr;
}

// Mesa's platform that needs neither a display server nor a device.
EGLDisplay surfaceless_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!has_extension(extensions, "EGL_EXT_platform_base") ||
      !has_extension(extensions, "EGL_MESA_platform_surfaceless"))
    throw no_context("no EGL driver offers the surfaceless platform");
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display =
      get_display ? get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                  : EGL_NO_DISPLAY;
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
    throw no_context("the EGL driver does not start");
  return display;
}

EGLContext make_context(EGLDisplay display, bool debug) {
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_DEBUG,
                               debug ? EGL_TRUE : EGL_FALSE,
                               EGL_NONE};
  if (!eglBindAPI(EGL_OPENGL_API)) throw no_context("the driver has no desktop OpenGL");
  const EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) throw no_context("the driver is older than OpenGL 4.5");
  return context;
}

void collect_message(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity,
                     GLsizei /*length*/, const GLchar* message, const void* errors) {
  const bool counts = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                      severity == GL_DEBUG_SEVERITY_HIGH;
  if (!counts) return;
  static_cast<std::vector<std::string>*>(const_cast<void*>(errors))->push_back(message);
}

}  // namespace

HeadlessContext::HeadlessContext(bool debug) : display_(surfaceless_display()) {
  context_ = make_context(display_, debug);
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
    eglDestroyContext(display_, context_);
    throw no_context("the driver cannot draw without a surface");
  }
  if (!debug) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect_message, &errors_);
}

// The display stays initialised: it is the process's, shared by every context.
HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

std::string HeadlessContext::description() const { return driver_description(); }

}  // namespace bosk
