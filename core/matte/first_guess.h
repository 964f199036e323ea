#pragma once

#include "core/base/progress.h"
#include "core/matte/scribbles.h"
#include "core/photo/photo.h"

namespace bosk {

// Strokes for photos that nobody has drawn over, to begin with and to be corrected: all of the tree
// is taken to be in every photo. What lies along a photo's edges is background; what lies about the
// place that all cameras look at (without cameras: the photo's middle) is tree in colours that are
// rare along the edges and flanks of all photos, background in those that are commoner there. A
// photo whose middle shows no such colours gets
// background alone; no strokes at all come back where that is so of all of them. The same at every
// thread count.
Scribbles guess_strokes(const Photos& photos, Progress& progress);

// What mattes begin from: the strokes as drawn where a photo has both kinds; else a guess with what
// was drawn over it, and a warning that says so. Without anything that could be guessed, as drawn.
Scribbles guess_where_none(Scribbles drawn, const Photos& photos, Progress& progress);

}  // namespace bosk
