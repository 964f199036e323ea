#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct CalibrateStepState {};

void draw_calibrate_step(Workspace& workspace);

}  // namespace bosk
