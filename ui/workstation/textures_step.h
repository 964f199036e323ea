#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct TexturesStepState {};

void draw_textures_step(Workspace& workspace);

}  // namespace bosk
