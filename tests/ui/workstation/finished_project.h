#pragma once

#include "tests/ui/workstation/tiny_project.h"

namespace bosk {

// A tiny project with mattes and all stages finished, in FOLDER/tree. A process computes it once;
// more are copies.
Project finished_project(const std::filesystem::path& folder);

}  // namespace bosk
