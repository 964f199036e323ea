#include "ui/workstation/matte_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_matte_step(Workspace&) {}

}  // namespace bosk
