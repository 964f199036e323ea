#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct PreviewStepState {};

void draw_preview_step(Workspace& workspace);

}  // namespace bosk
