#include "ui/workstation/volume_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_volume_step(Workspace&) {}

}  // namespace bosk
