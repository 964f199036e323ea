#pragma once

#include "ui/workstation/preview/compare_view.h"
#include "ui/workstation/preview/held_out.h"
#include "ui/workstation/preview/live_tree.h"

namespace bosk {

struct Workspace;

enum class PreviewTab { look, compare, scores };

// What the step remembers between frames.
struct PreviewStepState {
  PreviewTab tab = PreviewTab::look;
  LiveTreeState live;
  CompareState compare;
  HeldOutState held_out;
};

void draw_preview_step(Workspace& workspace);

// Says whether the package shown is of the project as it is, and offers to make it. Also for the
// step Export. Returns whether one is shown.
bool draw_package_state(Workspace& workspace);

}  // namespace bosk
