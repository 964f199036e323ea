#include "ui/widgets/figures_table.h"

#include <imgui.h>

namespace bosk {
namespace {

void line(const char* name, const char* format, double number) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::Text(format, number);
}

double mebibytes(std::size_t bytes) { return double(bytes) / double(1 << 20); }

void draw_levels(const FrameFigures& figures) {
  for (std::size_t level = 0; level < figures.by_level.size(); ++level) {
    if (figures.by_level[level] == 0) continue;
    line(("  level " + std::to_string(level)).c_str(), "%.0f", double(figures.by_level[level]));
  }
}

}  // namespace

void draw_figures_table(const FrameFigures& figures) {
  if (!ImGui::BeginTable("figures", 2)) return;
  line("picture", "%.1f ms", figures.picture_ms);
  line("  trees", "%.1f ms", figures.trees_ms);
  line("  sky, ground, shade", "%.1f ms", figures.scenery_ms);
  line("draw list", "%.2f ms", figures.list_ms);
  line("billboards", "%.0f", double(figures.billboards));
  draw_levels(figures);
  if (figures.budget > 0) line("budget", "%.0f", double(figures.budget));
  line("detail left", "%.2f", figures.detail);
  line("trees drawn", "%.0f", double(figures.instances_drawn));
  line("trees", "%.0f", double(figures.instances));
  line("overdraw, about", "%.1f", figures.overdraw);
  line(figures.bc3 ? "textures (BC3)" : "textures (RGBA8)", "%.2f MiB",
       mebibytes(figures.texture_bytes));
  line("indices", "%.2f MiB", mebibytes(figures.index_bytes));
  line("cells", "%.2f MiB", mebibytes(figures.cell_bytes));
  line("per frame", "%.2f MiB", mebibytes(figures.frame_bytes));
  ImGui::EndTable();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + 15.0f * ImGui::GetFontSize());
  ImGui::TextDisabled("%s", figures.driver.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace bosk
