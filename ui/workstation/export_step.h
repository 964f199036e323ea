#pragma once

namespace bosk {

struct Workspace;

// What the step remembers between frames.
struct ExportStepState {};

void draw_export_step(Workspace& workspace);

}  // namespace bosk
