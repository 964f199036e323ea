#include "ui/widgets/bars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "ui/widgets/landmarks.h"
#include "ui/widgets/theme.h"

namespace bosk {
namespace {

std::string value_text(double value, const std::string& unit) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return unit.empty() ? text.data() : text.data() + (" " + unit);
}

double largest(const std::vector<Bar>& bars) {
  double most = 0.0;
  for (const Bar& bar : bars) {
    if (std::isfinite(bar.value)) most = std::max(most, bar.value);
  }
  return most;
}

}  // namespace

std::optional<int> draw_bars(const std::string& name, const std::vector<Bar>& bars, int chosen,
                             const std::string& unit, ImVec2 area) {
  const ImVec2 left = ImGui::GetContentRegionAvail();
  if (area.x <= 0.0f) area.x = std::max(1.0f, left.x);
  if (area.y <= 0.0f) area.y = std::max(1.0f, left.y);
  const ImVec2 least = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(name.c_str(), area);
  const bool hovered = ImGui::IsItemHovered();
  mark(name);
  if (bars.empty()) return std::nullopt;
  const float step = area.x / float(bars.size());
  const int under =
      std::clamp(int((ImGui::GetIO().MousePos.x - least.x) / step), 0, int(bars.size()) - 1);
  const double most = largest(bars);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (int i = 0; i < int(bars.size()); ++i) {
    const double value = bars[std::size_t(i)].value;
    const double share = most > 0.0 && std::isfinite(value) ? value / most : 0.0;
    const ImVec2 top(least.x + step * float(i) + 1.0f,
                     least.y + area.y * float(1.0 - 0.95 * share) - 1.0f);
    const ImVec2 foot(least.x + step * float(i + 1) - 1.0f, least.y + area.y);
    const bool pointed = hovered && i == under;
    const Tone tone = i == chosen ? Tone::note : Tone::busy;
    draw.AddRectFilled(top, foot, colour_u32(tone, pointed ? 1.0f : 0.8f));
    if (i == chosen) draw.AddRect({top.x, least.y}, foot, colour_u32(Tone::note));
    mark(name + "/" + std::to_string(i), {top.x, least.y}, foot);
  }
  if (!hovered) return std::nullopt;
  const Bar& bar = bars[std::size_t(under)];
  tooltip(bar.name + ": " + value_text(bar.value, unit));
  return pressed ? std::optional(under) : std::nullopt;
}

}  // namespace bosk
