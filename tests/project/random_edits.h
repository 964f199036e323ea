#pragma once

#include <filesystem>

#include "core/base/random.h"
#include "core/project/edit.h"

namespace bosk {

// A project of three photos that lie nowhere, saved in the folder.
Project saved_project(const std::filesystem::path& folder);

// A stroke of a few points, as it is kept.
Stroke random_stroke(Random& random);
// Any kind of edit that fits the project, names in all kinds of letters.
Edit random_edit(Random& random, const Project& project);

// All that the project holds but its folder and journal.
std::string content_of(Project project);

}  // namespace bosk
