#include "ui/workstation/photos_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_photos_step(Workspace&) {}

}  // namespace bosk
