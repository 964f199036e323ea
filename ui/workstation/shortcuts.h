#pragma once

#include <string>
#include <vector>

namespace bosk {

struct Shortcut {
  std::string where, keys, what;
};

// Every key that the workstation knows, by place: the list that the window shows.
const std::vector<Shortcut>& shortcuts();

}  // namespace bosk
