#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/matte/matte.h"
#include "core/photo/decode.h"
#include "core/photo/photo.h"
#include "core/project/capture.h"

namespace bosk {

// Ready-made mattes for the photos, each taken through its photo's own resampling. A matte of one
// channel gives the opacity alone; its colour is estimated from the photo. Throws Error naming the
// file for a photo without matte, a matte that can't be read, doesn't fit its photo or is clear
// everywhere.
Mattes import_mattes(const std::vector<SourceFile>& files, const Photos& photos,
                     const DecodeLimits& limits, Progress& progress);

// What a file of strokes says, in the photo's working pixels. Throws Error naming the file.
Image<std::uint8_t> import_drawing(const SourceFile& file, const Photo& photo,
                                   const DecodeLimits& limits, const Progress& progress);

// Of those photos that have some, in the photos' working pixels: what the files say, with the
// strokes painted over. A photo of whose strokes nothing is left is not in it. Throws Error naming
// the file or photo that can't be read or doesn't fit.
Scribbles import_scribbles(const std::vector<SourceFile>& files, const Strokes& strokes,
                           const Photos& photos, const DecodeLimits& limits, Progress& progress);

}  // namespace bosk
