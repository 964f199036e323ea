#include "ui/workstation/shortcuts.h"

#include <imgui.h>

#include <algorithm>

#include "ui/widgets/keys.h"
#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"
#include "ui/workstation/workspace.h"
#include "ui/workstation/workstation.h"

namespace bosk {
namespace {

void hear_history(Workspace& workspace, bool shift) {
  for (const int key : workspace.input.keys) {
    if (key == 'Z' && !shift) undo(workspace);
    if ((key == 'Z' && shift) || key == 'Y') redo(workspace);
  }
}

}  // namespace

const std::vector<Shortcut>& shortcuts() {
  static const std::vector<Shortcut> list = {
      {"Everywhere", "Ctrl+Z", "undo"},
      {"Everywhere", "Ctrl+Shift+Z, Ctrl+Y", "redo"},
      {"Everywhere", "Ctrl+1 ... Ctrl+8", "go to a step"},
      {"Everywhere", "Ctrl+Plus, Ctrl+Minus, Ctrl+0", "larger, smaller, usual size of everything"},
      {"Everywhere", "F1", "this list"},
      {"Everywhere", "Ctrl+Q", "close; everything is kept"},
      {"Pictures", "wheel", "zoom at the mouse"},
      {"Pictures", "middle drag, Space + drag", "move the picture"},
      {"Pictures", "Home", "show all of it"},
      {"Calibrate", "click", "place the chosen point, or choose the one under the mouse"},
      {"Calibrate", "drag", "move a point"},
      {"Calibrate", "Delete", "the chosen point is not on this photo"},
      {"Calibrate", "Escape", "choose no point"},
      {"Calibrate", "L", "loupe, and none"},
      {"Calibrate", "Page Down, Page Up", "next and previous photo"},
      {"Calibrate", "B", "the brush that leaves out sky and what moves; [ and ] change its size"},
      {"Matte", "left drag", "paint a stroke"},
      {"Matte", "Alt", "while held: the background's brush for the tree's, and the other way"},
      {"Matte", "X", "swap tree and background"},
      {"Matte", "E", "eraser, and back"},
      {"Matte", "[ and ]", "smaller and larger brush; with Shift in larger steps"},
      {"Matte", "right drag", "to the right a larger brush, to the left a smaller one"},
      {"Matte", "F", "next view: photo, overlay, on black, on white, matte, pure foreground"},
      {"Matte", "S", "all photos side by side, and back"},
      {"Matte", "Page Down, Page Up", "next and previous photo"},
      {"Preview", "drag", "turn round the tree"},
      {"Preview", "right or middle drag, Shift + drag", "move sideways"},
      {"Preview", "wheel", "nearer or farther"},
      {"Preview", "T", "compare: photo or render"},
      {"Preview", "Page Up, Page Down", "compare: another photo"},
      {"Photos", "Left, Right, Escape", "the photo before, the next, back to all"},
      {"Photos", "Ctrl+click, Delete", "choose photos, remove those chosen"},
      {"Cameras", "drag, wheel, middle drag", "turn the view, come nearer, move it"},
      {"Cameras", "Home", "show all of them"},
      {"Options", "Ctrl+click", "type a number"},
      {"Options", "right click", "back to the default"},
  };
  return list;
}

void hear_shortcuts(Workspace& workspace) {
  const ImGuiIO& io = ImGui::GetIO();
  if (workspace.input.pressed(kKeyF1)) workspace.shortcuts_shown = !workspace.shortcuts_shown;
  const WindowInput& input = workspace.input;
  if (!(io.KeyCtrl || input.ctrl) || io.KeyAlt || input.alt) return;
  // A text field has an undo of its own
  if (workspace.session && !io.WantTextInput) hear_history(workspace, io.KeyShift || input.shift);
  for (const WorkStep step : kSteps) {
    if (workspace.input.pressed('1' + int(step))) workspace.step = step;
  }
  const float scale = scale_of(workspace);
  if (workspace.input.pressed(kKeyEqual)) ask_for_scale(workspace, scale + kScaleStep);
  if (workspace.input.pressed(kKeyMinus)) ask_for_scale(workspace, scale - kScaleStep);
  if (workspace.input.pressed('0')) ask_for_scale(workspace, 1.0f);
  if (workspace.input.pressed('Q')) workspace.close_wanted = true;
}

void draw_shortcuts(Workspace& workspace) {
  if (!workspace.shortcuts_shown) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Keys", &workspace.shortcuts_shown,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings) &&
      ImGui::BeginTable("keys", 3)) {
    std::string where;
    for (const Shortcut& shortcut : shortcuts()) {
      ImGui::TableNextColumn();
      if (shortcut.where != where) ImGui::TextDisabled("%s", shortcut.where.c_str());
      where = shortcut.where;
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(shortcut.keys.c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(shortcut.what.c_str());
    }
    ImGui::EndTable();
  }
  mark("keys", ImGui::GetWindowPos(),
       {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
        ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  ImGui::End();
}

}  // namespace bosk
