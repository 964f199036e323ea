#pragma once

#include <string>

namespace bosk {

struct Workspace;

struct StartPageState {
  std::string folder;   // typed: of a project to open or to make
  std::string trouble;  // why the last attempt failed
};

// Shown while no project is open: make one, open one, or one of those opened lately.
void draw_start_page(Workspace& workspace);

}  // namespace bosk
