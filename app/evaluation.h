#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/console.h"
#include "app/project_work.h"
#include "core/measure/contact_sheet.h"
#include "core/measure/score_table.h"
#include "core/package/tree_model.h"

namespace bosk {

// How a project's package compares with pictures that it was not made from.
struct Evaluation {
  std::string title;  // "4 of 24 photos held out"
  ScoreTable scores;
  std::vector<SheetRow> views;  // in the order of the scores
  std::size_t package_bytes = 0;
  TreeModel tree;
  std::vector<StageTime> times;  // of the stages that made the package, whenever they ran
};

// Leaves every n-th photo out of all stages, and compares the package with their mattes in the
// photos' undistorted pixels.
Evaluation evaluate_held_out(ProjectWork& work, int every, Console& console);

// Compares the package of all photos with RGBA pictures of other views, in each camera's own lens.
// A camera without a picture is passed over with a warning.
Evaluation evaluate_against(ProjectWork& work, const std::string& cameras,
                            const std::string& truth_folder, Console& console);

}  // namespace bosk
