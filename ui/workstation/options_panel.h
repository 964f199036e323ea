#pragma once

#include <string>
#include <vector>

namespace bosk {

struct Workspace;

// Widgets for a stage's options: range, unit and help are those of their descriptions. A change is
// one edit, made when the widget is let go; until then the project is as it was. Only the options
// named are shown; none named: all. Each is marked as landmark "options/STAGE.NAME".
void draw_stage_options(Workspace& workspace, const std::string& stage,
                        const std::vector<std::string>& names = {});

// A choice of the presets, each of which sets options of several stages in one edit.
void draw_preset_choice(Workspace& workspace);

}  // namespace bosk
