#pragma once

#include <array>
#include <cstdint>

#include "core/matte/strokes.h"

namespace bosk {

enum class MatteTool : std::uint8_t { tree, background, eraser };
inline constexpr int kMatteTools = 3;

inline constexpr double kLeastBrushPx = 0.5, kLargestBrushPx = 400.0;

// What the hand paints with. Radii are in working pixels, one for each tool.
struct MatteBrush {
  MatteTool tool = MatteTool::tree;
  MatteTool last_side = MatteTool::tree;  // tree or background: where the eraser came from
  std::array<double, kMatteTools> radius_px{10.0, 20.0, 20.0};

  double radius_of(MatteTool which) const { return radius_px[std::size_t(which)]; }
};

void take_tool(MatteBrush& brush, MatteTool tool);
void swap_sides(MatteBrush& brush);     // tree for background; from the eraser to the side before
void toggle_eraser(MatteBrush& brush);  // and back to the side before
// Of one tool, kept within its limits.
void set_radius(MatteBrush& brush, MatteTool tool, double radius_px);

// What is painted with while Alt is held or not: it flips tree and background.
MatteTool tool_in_use(const MatteBrush& brush, bool alt);
StrokeKind kind_of(MatteTool tool);
const char* name_of(MatteTool tool);

}  // namespace bosk
