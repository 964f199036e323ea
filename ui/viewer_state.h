#pragma once

#include <string>

#include "ui/camera_controls.h"
#include "ui/forest_scene.h"
#include "ui/frame_figures.h"
#include "ui/view_options.h"

namespace bosk {

// What the viewer's panels and keys read and change.
struct ViewerState {
  ViewOptions options;
  ViewCamera camera;
  FrameFigures figures;  // of the newest picture
  bool panel = true, keys = false;
  bool picture_wanted = false;  // a screenshot
  bool close_wanted = false;
  std::string message;  // of the last thing that was done, shown for a while
};

// Each draws one part of the overlay; in its own file.
void draw_figures_panel(const ViewerState& state);
void draw_look_panel(ViewerState& state);
void draw_keys_panel(ViewerState& state);
void draw_marks(const ForestScene& scene, const Camera& camera, const ViewerState& state);

}  // namespace bosk
