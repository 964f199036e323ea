#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace bosk {

// The Error for a failed system call: "PATH: cannot be DOING: reason; remedy", its kind from `code`
// (an errno). `doing` is a past participle: "read", "written", "renamed".
Error system_error(const std::filesystem::path& path, const std::string& doing, int code);

// Text safe to show on a terminal: control characters of a stranger's file name become '?'.
std::string printable(const std::string& text);

}  // namespace bosk
