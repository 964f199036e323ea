#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct PhotosStepState {};

void draw_photos_step(Workspace& workspace);

}  // namespace bosk
