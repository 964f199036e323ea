#include "ui/workstation/export_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_export_step(Workspace&) {}

}  // namespace bosk
