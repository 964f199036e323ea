#pragma once

#include <string>

#include "ui/widgets/theme.h"
#include "ui/workstation/work_step.h"

namespace bosk {

struct Workspace;

// What a person wants to know of a step before anything else.
struct StepGuide {
  Tone tone = Tone::muted;
  std::string state;  // a word or two: "done", "out of date", "needs cameras"
  std::string needs;  // what is missing before it can begin; empty: nothing
  std::string has;    // what there is
  std::string next;   // what to do now
};

// A function of the workspace alone.
StepGuide guide_of(const Workspace& workspace, WorkStep step);

// The last stage that the step is for; empty: it has none of its own.
std::string stage_of(WorkStep step);

}  // namespace bosk
