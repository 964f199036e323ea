#include "ui/widgets/table_head.h"

#include <imgui.h>

#include "ui/widgets/theme.h"

namespace bosk {

void draw_table_head(std::span<const TableColumn> columns) {
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const TableColumn& column : columns) ImGui::TableSetupColumn(column.name.c_str());
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const TableColumn& column : columns) {
    ImGui::TableNextColumn();
    ImGui::TableHeader(column.name.c_str());
    tooltip(column.help);
  }
}

}  // namespace bosk
