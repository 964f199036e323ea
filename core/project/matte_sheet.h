#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/matte/matte_doubt.h"
#include "core/photo/photo.h"

namespace bosk {

// A contact sheet to judge mattes by: one page, each photo beside its matte, over black and over
// magenta (which shows rims and haze that black and white hide), those first that stand out in
// doubt. `photos`, `mattes` and `doubts` in one order. Replaced atomically; throws Error where it
// can't be written, Cancelled.
void write_matte_sheet(const std::filesystem::path& path, const std::string& title,
                       const Photos& photos, const Mattes& mattes,
                       const std::vector<MatteDoubt>& doubts, Progress& progress);

}  // namespace bosk
