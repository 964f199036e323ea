#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace bosk {

// Where a shell would find the program; none when PATH has no such executable.
std::optional<std::filesystem::path> find_program(const std::string& name);

// Runs the program, without a shell, in `folder` with nothing to read and what it says going to
// `log`, and waits for its end. Returns its exit status, or 128 and the signal that ended it. When
// `progress` is asked to stop it is ended too, and Cancelled thrown. Throws Error when it cannot be
// started.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& folder, const std::filesystem::path& log,
                const Progress& progress);

}  // namespace bosk
