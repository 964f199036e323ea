#include "tests/ui/workstation/hand.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "ui/widgets/keys.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workstation.h"

namespace bosk {
namespace {

void map_keys(ImGuiIO& io) {
  const std::pair<ImGuiKey_, int> keys[] = {{ImGuiKey_Tab, kKeyTab},
                                            {ImGuiKey_LeftArrow, kKeyLeft},
                                            {ImGuiKey_RightArrow, kKeyRight},
                                            {ImGuiKey_UpArrow, kKeyUp},
                                            {ImGuiKey_DownArrow, kKeyDown},
                                            {ImGuiKey_Home, kKeyHome},
                                            {ImGuiKey_End, kKeyEnd},
                                            {ImGuiKey_Delete, kKeyDelete},
                                            {ImGuiKey_Backspace, kKeyBackspace},
                                            {ImGuiKey_Space, kKeySpace},
                                            {ImGuiKey_Enter, kKeyEnter},
                                            {ImGuiKey_Escape, kKeyEscape},
                                            {ImGuiKey_A, 'A'},
                                            {ImGuiKey_C, 'C'},
                                            {ImGuiKey_V, 'V'},
                                            {ImGuiKey_X, 'X'},
                                            {ImGuiKey_Y, 'Y'},
                                            {ImGuiKey_Z, 'Z'}};
  for (const auto& [of_imgui, number] : keys) io.KeyMap[of_imgui] = number;
}

}  // namespace

PictureDevice MemoryTextures::device() {
  return {[this](const Image<glm::u8vec4>& picture, ImTextureID old) {
            ++uploads;
            const ImTextureID id = old ? old : reinterpret_cast<ImTextureID>(++last);
            pictures[id] = picture;
            return id;
          },
          [this](ImTextureID id) { pictures.erase(id); }};
}

Hand::Hand(const ImVec2& size, const std::filesystem::path& settings)
    : Hand(size, settings, HandScreen{textures_.device(), {}, {}, {}}) {}

Hand::Hand(const ImVec2& size, const std::filesystem::path& settings, HandScreen screen)
    : screen_(std::move(screen)) {
  if (!ImGui::GetCurrentContext()) ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = size;
  io.DeltaTime = 1.0f / 60.0f;
  io.MousePos = {-1, -1};
  map_keys(io);
  apply_theme(1.0f);
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  if (!screen_.begin_frame) io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  workspace_ = std::make_unique<Workspace>(
      screen_.device, [] {}, settings);
  frame(2);
}

Hand::~Hand() {
  workspace_.reset();
  if (screen_.close) screen_.close();
  ImGui::DestroyContext();
}

void Hand::frame(int count) {
  for (int i = 0; i < count; ++i) {
    if (screen_.begin_frame) screen_.begin_frame();
    ImGui::NewFrame();
    draw_workstation(*workspace_);
    ImGui::Render();
    if (screen_.end_frame) screen_.end_frame();
  }
}

bool Hand::wait_for(const std::function<bool()>& reached, double seconds) {
  const auto start = std::chrono::steady_clock::now();
  while (!reached()) {
    if (std::chrono::steady_clock::now() - start > std::chrono::duration<double>(seconds)) {
      return false;
    }
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

bool Hand::settle(double seconds) {
  // A job's end may start another, in the frame that installs its result or the next
  int quiet_frames = 0;
  return wait_for(
      [&] {
        quiet_frames = workspace_->jobs.at_rest() ? quiet_frames + 1 : 0;
        return quiet_frames > 3;
      },
      seconds);
}

Landmark Hand::at(const std::string& landmark) {
  const auto place = workspace_->landmarks.find(landmark);
  if (place != workspace_->landmarks.end()) return place->second;
  std::string known;
  for (const auto& [name, mark] : workspace_->landmarks) known += " " + name;
  ADD_FAILURE() << "nothing on the screen is called " << landmark << "; there are:" << known;
  return {};
}

bool Hand::sees(const std::string& landmark) const {
  return workspace_->landmarks.count(landmark) > 0;
}

bool Hand::is_enabled(const std::string& landmark) { return at(landmark).enabled; }

void Hand::move_to(const ImVec2& place) {
  ImGui::GetIO().MousePos = place_ = place;
  workspace_->input.mouse_path.push_back(place);
  frame();
}

void Hand::press(int mouse_button) {
  ImGui::GetIO().MouseDown[mouse_button] = true;
  if (mouse_button == 0) {
    workspace_->input.pressed_at = workspace_->input.mouse_path.size();
    workspace_->input.mouse_path.push_back(place_);
  }
  frame();
}

void Hand::release(int mouse_button) {
  ImGui::GetIO().MouseDown[mouse_button] = false;
  if (mouse_button == 0) {
    workspace_->input.released_at = workspace_->input.mouse_path.size();
    workspace_->input.mouse_path.push_back(place_);
  }
  frame();
}

void Hand::click_at(const ImVec2& place, int mouse_button) {
  move_to(place);
  press(mouse_button);
  release(mouse_button);
  frame();
}

void Hand::click(const std::string& landmark, int mouse_button) {
  click_at(at(landmark).middle(), mouse_button);
}

void Hand::drag(const ImVec2& from, const ImVec2& to, int steps, int mouse_button) {
  move_to(from);
  press(mouse_button);
  for (int i = 1; i <= steps; ++i) {
    const float share = float(i) / float(steps);
    move_to({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
  release(mouse_button);
  frame();
}

void Hand::wheel(float steps) {
  ImGui::GetIO().MouseWheel = steps;
  frame();
  ImGui::GetIO().MouseWheel = 0.0f;
  frame();
}

void Hand::hold(int number, bool down) {
  ImGui::GetIO().KeysDown[number] = down;
  if (down) workspace_->input.keys.push_back(number);
  frame();
}

void Hand::hold_modifiers(bool ctrl, bool shift, bool alt) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = ctrl;
  io.KeyShift = shift;
  io.KeyAlt = alt;
  frame();
}

void Hand::key(int number, bool ctrl, bool shift, bool alt) {
  hold_modifiers(ctrl, shift, alt);
  hold(number, true);
  hold(number, false);
  hold_modifiers(false, false, false);
}

void Hand::type(const std::string& text) {
  for (const char letter : text) {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(letter));
    frame();
  }
}

void Hand::drop(const std::vector<std::filesystem::path>& paths) {
  workspace_->input.dropped = paths;
  frame();
}

}  // namespace bosk
