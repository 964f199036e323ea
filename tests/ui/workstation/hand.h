#pragma once

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ui/workstation/workspace.h"

namespace bosk {

// Draws frames for a Hand: without anything, or into an off-screen picture.
struct HandScreen {
  PictureDevice device;
  std::function<void()> begin_frame, end_frame;  // around draw_workstation
  std::function<void()> close;                   // once the workspace has gone
};

// Textures that are nowhere but in memory, for tests to look into.
struct MemoryTextures {
  std::map<ImTextureID, Image<glm::u8vec4>> pictures;
  std::intptr_t last = 0;
  int uploads = 0;

  PictureDevice device();
};

// A person at the workstation without a window: one frame for each change of mouse or key, a
// sixtieth of a second apart, the same every time.
class Hand {
 public:
  explicit Hand(const ImVec2& size = {1400, 900}, const std::filesystem::path& settings = {});
  Hand(const ImVec2& size, const std::filesystem::path& settings, HandScreen screen);
  ~Hand();
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  Workspace& workspace() { return *workspace_; }
  const MemoryTextures& textures() const { return textures_; }

  void frame(int count = 1);
  // Frames until no job is left and all is installed. False after `seconds`.
  bool settle(double seconds = 120.0);
  // Frames until `reached` holds. False after `seconds`.
  bool wait_for(const std::function<bool()>& reached, double seconds = 120.0);

  // The landmark of the newest frame; fails the test, and gives one at the corner, without it.
  Landmark at(const std::string& landmark);
  bool sees(const std::string& landmark) const;
  bool is_enabled(const std::string& landmark);

  void move_to(const ImVec2& place);
  void press(int mouse_button = 0);
  void release(int mouse_button = 0);
  void click(const std::string& landmark, int mouse_button = 0);
  void click_at(const ImVec2& place, int mouse_button = 0);
  void drag(const ImVec2& from, const ImVec2& to, int steps = 8, int mouse_button = 0);
  void wheel(float steps);
  // A key with modifiers held, pressed and released.
  void key(int number, bool ctrl = false, bool shift = false, bool alt = false);
  void hold(int number, bool down);
  void hold_modifiers(bool ctrl, bool shift, bool alt);
  // Into the field that has the keyboard.
  void type(const std::string& text);
  void drop(const std::vector<std::filesystem::path>& paths);

 private:
  MemoryTextures textures_;
  HandScreen screen_;
  std::unique_ptr<Workspace> workspace_;
  ImVec2 place_{-1, -1};  // of the mouse; Dear ImGui rounds it
};

}  // namespace bosk
