#include "ui/workstation/matte/matte_brush.h"

#include <algorithm>

namespace bosk {
namespace {

MatteTool other_side(MatteTool side) {
  return side == MatteTool::tree ? MatteTool::background : MatteTool::tree;
}

}  // namespace

void take_tool(MatteBrush& brush, MatteTool tool) {
  brush.tool = tool;
  if (tool != MatteTool::eraser) brush.last_side = tool;
}

void swap_sides(MatteBrush& brush) {
  const bool erasing = brush.tool == MatteTool::eraser;
  take_tool(brush, erasing ? brush.last_side : other_side(brush.tool));
}

void toggle_eraser(MatteBrush& brush) {
  take_tool(brush, brush.tool == MatteTool::eraser ? brush.last_side : MatteTool::eraser);
}

void set_radius(MatteBrush& brush, MatteTool tool, double radius_px) {
  brush.radius_px[std::size_t(tool)] = std::clamp(radius_px, kLeastBrushPx, kLargestBrushPx);
}

MatteTool tool_in_use(const MatteBrush& brush, bool alt) {
  return alt && brush.tool != MatteTool::eraser ? other_side(brush.tool) : brush.tool;
}

StrokeKind kind_of(MatteTool tool) {
  if (tool == MatteTool::eraser) return StrokeKind::erase;
  return tool == MatteTool::tree ? StrokeKind::foreground : StrokeKind::background;
}

const char* name_of(MatteTool tool) {
  constexpr const char* kNames[] = {"Tree", "Background", "Eraser"};
  return kNames[std::size_t(tool)];
}

}  // namespace bosk
