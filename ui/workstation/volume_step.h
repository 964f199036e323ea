#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct VolumeStepState {};

void draw_volume_step(Workspace& workspace);

}  // namespace bosk
