#pragma once

#include <span>
#include <string>

namespace bosk {

struct TableColumn {
  std::string name, help;  // what stands above it, and the tooltip there
};

// The head of the table just begun, with as many columns. It and the first column stay where they
// are while the rest scrolls.
void draw_table_head(std::span<const TableColumn> columns);

}  // namespace bosk
