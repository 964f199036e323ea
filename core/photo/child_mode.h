#pragma once

#include <optional>

namespace bosk {

// Call this first in main() of every program that reads photos, and return its value if it has one:
// the program was then started by decode_photo as a child to decode one photo, and has done so.
std::optional<int> run_child_mode(int argc, char** argv);

}  // namespace bosk
