#include "ui/workstation/codebook_step.h"

#include "ui/workstation/workspace.h"

namespace bosk {

void draw_codebook_step(Workspace&) {}

}  // namespace bosk
