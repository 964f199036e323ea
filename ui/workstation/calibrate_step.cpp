#include "ui/workstation/calibrate_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_calibrate_step(Workspace&) {}

}  // namespace bosk
