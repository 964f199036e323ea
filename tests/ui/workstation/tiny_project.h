#pragma once

#include <filesystem>

#include "core/phantom/phantom_options.h"
#include "core/project/project.h"

namespace bosk {

// Eight photographs, 64 x 80 pixels, of a small sparse tree, for tests that go through all steps.
PhantomOptions tiny_capture();
// Lays it out as `bosk phantom` does: photos, mattes, scribbles, transforms.json. A process makes
// it once; more folders are copies.
void write_tiny_capture(const std::filesystem::path& folder);

// What of the capture a project starts with, beside photos and cameras.
enum class TinyStart { nothing, mattes, scribbles };

// Options with which all stages take about a second.
Recipe tiny_recipe();

// The capture in FOLDER/capture, and a project of it, with such options, in FOLDER/tree.
Project make_tiny_project(const std::filesystem::path& folder, TinyStart start = TinyStart::mattes);

}  // namespace bosk
