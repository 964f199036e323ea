#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/measure/contact_sheet.h"
#include "core/measure/score_table.h"
#include "core/package/tree_model.h"
#include "core/project/run.h"

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

// The project, what it is evaluated on, and how its stages are run: run_stages itself, or with the
// project's lock taken first.
struct EvaluationSource {
  Project project;
  Capture capture;
  std::function<Run(const Capture&, const std::vector<std::string>& wanted, Share)> run;
};

// Whoever holds the project's lock runs its stages like this. `progress` must outlive it.
EvaluationSource evaluation_source(const Project& project, const Capture& capture,
                                   Progress& progress);

// Leaves every n-th photo out of all stages, and compares the package with their mattes in the
// photos' undistorted pixels.
Evaluation evaluate_held_out(const EvaluationSource& source, int every, Progress& progress);

// Compares the package of all photos with RGBA pictures of other views, in each camera's own lens.
// A camera without a picture is passed over with a warning.
Evaluation evaluate_against(const EvaluationSource& source, const std::filesystem::path& cameras,
                            const std::filesystem::path& truth_folder, Progress& progress);

}  // namespace bosk
