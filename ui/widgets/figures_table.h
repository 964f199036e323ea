#pragma once

#include "ui/frame_figures.h"

namespace bosk {

// What the newest picture of a forest took: a table in the current window.
void draw_figures_table(const FrameFigures& figures);

}  // namespace bosk
