#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/workstation/photos/camera_wheel.h"

namespace bosk {

// A part of the ring that stands out; angles as in CameraWheel.
struct WheelArc {
  double start = 0.0, size = 0.0;
  std::string words;  // within it
};

// A place that is asked for.
struct WheelPin {
  glm::dvec2 place_m{0.0};  // from the middle
  std::string words;        // beside it
};

// What the mouse did on the wheel: names of photos, empty for none.
struct WheelHand {
  std::optional<std::string> pointed_at;  // none: the mouse is elsewhere
  std::string clicked;
};

// Cameras from above in a square of `side` points, north (y) up. Marked as landmark `name`, each
// camera as `spokes` + its name. The camera of the photo that is pointed at stands out.
WheelHand draw_wheel(const std::string& name, const std::string& spokes, const CameraWheel& wheel,
                     const std::vector<WheelArc>& arcs, const std::vector<WheelPin>& pins,
                     float side, const std::string& pointed_at);

}  // namespace bosk
