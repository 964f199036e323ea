#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct CodebookStepState {};

void draw_codebook_step(Workspace& workspace);

}  // namespace bosk
