#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct MatteStepState {};

void draw_matte_step(Workspace& workspace);

}  // namespace bosk
