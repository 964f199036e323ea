#include "ui/window.h"

#include <GL/glcorearb.h>
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/render/gl/gl_object.h"
#include "ui/gl_overlay.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/theme.h"

namespace bosk {
namespace {

static_assert(kKeySpace == GLFW_KEY_SPACE && kKeyMinus == GLFW_KEY_MINUS &&
              kKeyEqual == GLFW_KEY_EQUAL && kKeyLeftBracket == GLFW_KEY_LEFT_BRACKET &&
              kKeyRightBracket == GLFW_KEY_RIGHT_BRACKET && kKeyEscape == GLFW_KEY_ESCAPE &&
              kKeyEnter == GLFW_KEY_ENTER && kKeyTab == GLFW_KEY_TAB &&
              kKeyBackspace == GLFW_KEY_BACKSPACE && kKeyDelete == GLFW_KEY_DELETE &&
              kKeyRight == GLFW_KEY_RIGHT && kKeyLeft == GLFW_KEY_LEFT &&
              kKeyDown == GLFW_KEY_DOWN && kKeyUp == GLFW_KEY_UP &&
              kKeyPageUp == GLFW_KEY_PAGE_UP && kKeyPageDown == GLFW_KEY_PAGE_DOWN &&
              kKeyHome == GLFW_KEY_HOME && kKeyEnd == GLFW_KEY_END && kKeyF1 == GLFW_KEY_F1);

constexpr std::size_t kMostMousePlaces = 4096;  // kept between two frames

std::string glfw_reason() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return reason ? reason : "no reason given";
}

}  // namespace

// Set before Dear ImGui's own callbacks, which pass events on to these.
void Window::listen(GLFWwindow* window) {
  static const auto heard_by = [](GLFWwindow* of) -> Heard& {
    return *static_cast<Heard*>(glfwGetWindowUserPointer(of));
  };
  const auto remember = [](GLFWwindow* of) { heard_by(of).any = true; };
  static const auto note = remember;
  glfwSetWindowRefreshCallback(window, remember);
  glfwSetWindowCloseCallback(window, remember);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* of, int, int) { note(of); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* of, int focused) {
    note(of);
    if (focused == 0) heard_by(of).focus_lost = true;
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* of, int) { note(of); });
  glfwSetCursorPosCallback(window, [](GLFWwindow* of, double x, double y) {
    note(of);
    auto& path = heard_by(of).mouse_path;
    heard_by(of).mouse = {x, y};
    if (path.size() < kMostMousePlaces) path.emplace_back(x, y);
  });
  glfwSetDropCallback(window, [](GLFWwindow* of, int count, const char** paths) {
    note(of);
    auto& dropped = heard_by(of).dropped;
    dropped.insert(dropped.end(), paths, paths + count);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* of, int button, int action, int) {
    note(of);
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    Heard& heard = heard_by(of);
    // Not where the mouse is by now, which the window system would be asked for, but where it was
    (action == GLFW_PRESS ? heard.left.down : heard.left.up) = heard.mouse_path.size();
    heard.mouse_path.push_back(heard.mouse);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* of, double, double) { note(of); });
  glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int held) {
    note(of);
    Heard& heard = heard_by(of);
    if (action == GLFW_PRESS) heard.pressed_keys.push_back(key);
    if (action == GLFW_RELEASE) return;
    heard.typed_keys.push_back(key);
    heard.typed_modifiers.ctrl |= (held & GLFW_MOD_CONTROL) != 0;
    heard.typed_modifiers.shift |= (held & GLFW_MOD_SHIFT) != 0;
    heard.typed_modifiers.alt |= (held & GLFW_MOD_ALT) != 0;
  });
}

Window::Window(const std::string& title, const glm::ivec2& size, const std::string& otherwise) {
  if (!glfwInit()) {
    throw Error("no window can be opened: " + glfw_reason() + "; set DISPLAY, or " + otherwise);
  }
  try {
    make_window(title, size, otherwise);
    start_overlay();
  } catch (...) {
    glfwTerminate();
    throw;
  }
}

void Window::make_window(const std::string& title, const glm::ivec2& size,
                         const std::string& otherwise) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (!window_) {
    throw Error("no window with OpenGL 4.5 can be opened: " + glfw_reason() +
                "; install the graphics card's driver or Mesa's (Debian: libgl1-mesa-dri), or " +
                otherwise);
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
}

void Window::start_overlay() {
  glfwSetWindowUserPointer(window_, &heard_);
  listen(window_);
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // else imgui.ini appears where the program was started
  float scale = 1.0f;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  scale = std::clamp(scale, 1.0f, 4.0f);
  io.FontGlobalScale = scale;
  ImGui::StyleColorsDark();
  ImGui::GetStyle().ScaleAllSizes(scale);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  start_gl_overlay();
}

Window::~Window() {
  stop_gl_overlay();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::close_asked() const { return glfwWindowShouldClose(window_) != 0; }

glm::ivec2 Window::size_px() const {
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return glm::ivec2(0);
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

std::string Window::driver() const { return driver_description(); }

double Window::seconds() const { return glfwGetTime(); }

bool Window::wait(double seconds) {
  heard_.any = false;
  if (seconds > 0.0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
  return heard_.any;
}

void Window::begin_overlay() {
  begin_gl_overlay();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Window::draw_overlay() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  ImGui::Render();
  draw_gl_overlay();
}

void Window::present() { glfwSwapBuffers(window_); }

void Window::wake() { glfwPostEmptyEvent(); }

void Window::resize(const glm::ivec2& size) {
  glm::ivec2 place(0), room(size);
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
    glfwGetMonitorWorkarea(monitor, &place.x, &place.y, &room.x, &room.y);
  }
  const glm::ivec2 fitting = glm::min(size, room);
  glfwSetWindowSize(window_, fitting.x, fitting.y);
}

float Window::content_scale() const {
  float scale = 1.0f;
  glfwGetWindowContentScale(window_, &scale, nullptr);
  return std::clamp(scale, kLeastScale, kLargestScale);
}

void Window::set_theme(float scale) {
  apply_theme(scale);
  ImGui::GetIO().FontGlobalScale = 1.0f;
  restart_gl_overlay();
}

}  // namespace bosk
