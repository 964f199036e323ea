#pragma once

#include <filesystem>
#include <vector>

namespace bosk {

struct Workspace;

// Takes what was dropped on the window or typed in step Photos for what it is (path_kinds.h):
// photos are added, in one edit; cameras imported; of a project, that one opened and nothing else
// done. The step that took something is shown and says what was done; Photos where there are both,
// or nothing that Bosk knows. But while step Matte is shown, one folder of files that are called
// like the project's photos is taken for their mattes.
void take_paths(Workspace& workspace, const std::vector<std::filesystem::path>& named);

// The same with what the window heard, while a project is open.
void hear_drops(Workspace& workspace);

}  // namespace bosk
