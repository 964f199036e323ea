#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "core/project/project.h"

namespace bosk {

// The content of project.json. Throws Error when a file name, photo name or option is not valid
// UTF-8.
std::string project_text(const Project& project);
// Throws Error, naming `file`, when the text is damaged or of a newer Bosk. The folder stays empty.
Project project_of_text(std::span<const std::byte> text, const std::filesystem::path& file);

// Whether project.json can hold the text: valid UTF-8.
bool is_storable(const std::string& text);

// What project.json says by itself, without the journal; errors as read_project.
Project read_saved_project(const std::filesystem::path& folder);
// Throws Error unless the folder holds a project.
void require_project(const std::filesystem::path& folder);

}  // namespace bosk
