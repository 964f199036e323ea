#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace bosk {

// A field for a path with its button behind it.
struct PathField {
  std::string name, hint;           // landmark of the field; what is written in it while empty
  std::string button, label, help;  // landmark, text and tooltip of the button
  std::string obstacle;             // why nothing can be done with a path now; empty: it can
};
// The path, once it is given by Enter or button; the field is then empty again.
std::optional<std::filesystem::path> draw_path_field(const PathField& field, std::string& typed);

}  // namespace bosk
