#pragma once

#include "core/project/capture.h"

namespace bosk {

struct Workspace;

// Brings Workspace::capture up to date after an edit: where only strokes changed it is the same
// with those; where files changed they are read and hashed again by a job, and until then there is
// none.
void refresh_capture(Workspace& workspace);

// Reads the project's files again, as after somebody changed them outside.
void reread_files(Workspace& workspace);

// Whether nothing tells the tree from its background: neither mattes nor drawings of strokes, nor
// strokes of both kinds painted on one photo.
bool begins_with_a_guess(const Capture& capture);

}  // namespace bosk
