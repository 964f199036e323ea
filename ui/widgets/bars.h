#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

namespace bosk {

struct Bar {
  std::string name;
  double value = 0.0;  // 0 or more
};

// Upright bars side by side, as high as their share of the largest; the chosen one (-1: none)
// stands out, and the one under the mouse is named with its value and `unit`. In an item of `area`
// (0: all that is left), marked as landmark `name`; bar i as "name/i". Returns the bar that was
// pressed.
std::optional<int> draw_bars(const std::string& name, const std::vector<Bar>& bars, int chosen,
                             const std::string& unit, ImVec2 area = {0, 0});

}  // namespace bosk
