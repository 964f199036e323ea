#pragma once

#include <imgui.h>

#include "ui/widgets/pictures.h"

namespace bosk {

// Draws the picture as large as the area allows, in its middle, turned upright by its EXIF
// orientation (1 to 8). Nothing where there is no picture.
void draw_fitted(const Texture& texture, const ImVec2& least, const ImVec2& area,
                 int orientation = 1);

}  // namespace bosk
