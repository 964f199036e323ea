#pragma once

#include <imgui.h>

#include <map>
#include <string>

namespace bosk {

// Where named items of the newest frame are on the screen, in Dear ImGui's coordinates: Dear ImGui
// itself forgets. Tests and programs that drive the window for a person find their way by it.
struct Landmark {
  ImVec2 least, most;
  bool enabled = true;

  ImVec2 middle() const { return {0.5f * (least.x + most.x), 0.5f * (least.y + most.y)}; }
};
using Landmarks = std::map<std::string, Landmark>;

// Begins a frame: items marked from now on are put into `landmarks`, which must outlive the frame.
void begin_landmarks(Landmarks& landmarks);

// Names the item drawn last. Nothing happens where nobody keeps landmarks, or the item is clipped
// away. Names are "step/what", such as "matte/undo"; of two items of one name the later counts.
void mark(const std::string& name, bool enabled = true);
// The same for a part of the screen that is no item.
void mark(const std::string& name, const ImVec2& least, const ImVec2& most);

}  // namespace bosk
