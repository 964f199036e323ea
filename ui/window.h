#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace bosk {

// A window with an OpenGL 4.5 context that is current on this thread, and Dear ImGui in it. One at
// a time; on the main thread.
class Window {
 public:
  // Throws Error where there is no display or no OpenGL 4.5, with what to do; `otherwise` is what
  // serves without a window ("use --screenshot").
  Window(const std::string& title, const glm::ivec2& size, const std::string& otherwise);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool close_asked() const;
  glm::ivec2 size_px() const;  // of the framebuffer; 0 when the window is hidden
  std::string driver() const;  // renderer and version, in the driver's words
  double seconds() const;      // since some start

  // Waits for an event, at most `seconds`; 0 looks only. Returns whether there was one.
  bool wait(double seconds);
  // GLFW's numbers of the keys pressed since the last call.
  std::vector<int> take_pressed_keys() { return std::exchange(heard_.pressed_keys, {}); }
  // The same with the repeats of keys held down.
  std::vector<int> take_typed_keys() { return std::exchange(heard_.typed_keys, {}); }
  // Ctrl, Shift and Alt as they were held with any of these; asked after take_typed_keys. A slow
  // frame sees only that they were let go again.
  struct Modifiers {
    bool ctrl = false, shift = false, alt = false;
  };
  Modifiers take_typed_modifiers() { return std::exchange(heard_.typed_modifiers, {}); }
  std::vector<std::filesystem::path> take_dropped() { return std::exchange(heard_.dropped, {}); }
  // Where the mouse was since the last call, oldest first: a slow frame sees only its last place.
  std::vector<glm::vec2> take_mouse_path() { return std::exchange(heard_.mouse_path, {}); }
  // How many of those places came before the left button last went down or up; none: it didn't.
  struct LeftButton {
    std::optional<std::size_t> down, up;
  };
  LeftButton take_left_button() { return std::exchange(heard_.left, {}); }
  // Whether the window lost the keyboard since the last call.
  bool take_focus_loss() { return std::exchange(heard_.focus_lost, false); }
  // Makes the window so large, as far as the screen has room.
  void resize(const glm::ivec2& size);
  // What the screen asks for: 1 at about 96 dots an inch.
  float content_scale() const;
  // Colours, font and spacing of the panels; not between begin_overlay and draw_overlay.
  void set_theme(float scale);
  void begin_overlay();
  void draw_overlay();  // all that was drawn with Dear ImGui since begin_overlay
  void present();
  // Ends a wait at once; from any thread, while a window lives.
  static void wake();

 private:
  void make_window(const std::string& title, const glm::ivec2& size, const std::string& otherwise);
  void start_overlay();

  // What callbacks write.
  struct Heard {
    bool any = false;
    std::vector<int> pressed_keys, typed_keys;
    Modifiers typed_modifiers;
    std::vector<std::filesystem::path> dropped;
    std::vector<glm::vec2> mouse_path;
    glm::vec2 mouse{0.0f};  // by the newest event
    LeftButton left;
    bool focus_lost = false;
  };
  static void listen(GLFWwindow* window);

  GLFWwindow* window_ = nullptr;
  Heard heard_;
};

}  // namespace bosk
