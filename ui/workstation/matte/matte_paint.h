#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/photo/photo.h"
#include "ui/widgets/image_view.h"

namespace bosk {

struct Workspace;

// Where a place of the upright picture of the working photo is in the photo as taken; none where
// the lens gives no answer. `orientation` is EXIF's.
std::optional<glm::dvec2> taken_from_upright(const Photo& photo, int orientation,
                                             const glm::dvec2& upright_px);

// Lets the mouse paint on the canvas that lies at `place`, and resize the brush by a right drag.
void hear_brush(Workspace& workspace, const ImagePlace& place);

// A circle as large as the brush, with a sign for its tool: never to be taken for paint.
void draw_brush(const Workspace& workspace, const ImagePlace& place);

// Ends the stroke in hand, if any, and keeps it: it becomes one edit. Also where the step is left,
// the window loses the keyboard, or the project is closed.
void keep_stroke_in_hand(Workspace& workspace);

}  // namespace bosk
