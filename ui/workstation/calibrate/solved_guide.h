#pragma once

#include "ui/workstation/guide.h"

namespace bosk {

// Of step Calibrate for a project with photos and without a camera file.
StepGuide solved_guide(const Workspace& workspace);

}  // namespace bosk
