#include "ui/workstation/textures_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_textures_step(Workspace&) {}

}  // namespace bosk
