#pragma once

#include "ui/camera_controls.h"

namespace bosk {

// What the wheel, as Dear ImGui's current frame heard it, does to the camera.
ViewCamera zoomed_by_wheel(const ViewCamera& view, const Terrain& terrain);

// What dragging does in a picture `height_px` high, in pixels of the framebuffer: the left button
// turns; the right, the middle, or Shift with the left move sideways.
ViewCamera moved_by_drag(const ViewCamera& view, const Terrain& terrain, double height_px,
                         double view_angle);

}  // namespace bosk
