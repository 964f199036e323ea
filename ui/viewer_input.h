#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "ui/forest_scene.h"
#include "ui/viewer_state.h"

namespace bosk {

// What keys do, one line each: the help panel and the command line's help show this list.
struct KeyHelp {
  std::string keys, what;
};
const std::vector<KeyHelp>& viewer_keys();

// Applies what Dear ImGui's current frame heard of mouse and keys to the state, unless a panel
// wants it. `pressed` are the keys pressed since the last frame, `seconds` ago, also those that
// were released again, which Dear ImGui 1.86 forgets when a frame takes long. Returns whether keys
// that move the eye are held down, so that the next frame must follow at once.
bool apply_input(ViewerState& state, const ForestScene& scene, const glm::ivec2& size_px,
                 std::span<const int> pressed, double seconds);

}  // namespace bosk
