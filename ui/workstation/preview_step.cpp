#include "ui/workstation/preview_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_preview_step(Workspace&) {}

}  // namespace bosk
