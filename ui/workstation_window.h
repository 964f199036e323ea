#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>

#include "core/base/progress.h"

namespace bosk {

struct WorkstationStart {
  std::optional<std::filesystem::path> project;  // none: the start page
  glm::ivec2 size{1400, 900};
  // Where the named items of the newest frame are written, a line each: name, left, top, right,
  // bottom in pixels of the window, 1 where it can be used. For programs that drive the window for
  // a person; empty: nowhere.
  std::filesystem::path landmarks;
};

// Opens the workstation and returns once it is closed; what runs then is stopped, and all edits are
// kept. Throws Error where no window opens or the project cannot be opened, Cancelled when
// `progress` was asked to stop.
void run_workstation(const WorkstationStart& start, const Progress& progress);

}  // namespace bosk
