#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/stage_options.h"
#include "core/project/project.h"

namespace bosk {

// What `bosk calibrate` is given; paths as typed, empty: not given.
struct CalibrateArguments {
  std::string folder;
  std::string report, sightings, boards, lens, save_lens;
  std::string board;                                // "9x6"
  double square_mm = 0.0;                           // 0: not given
  std::vector<std::string> tapes, heights, points;  // words, in threes, twos and fours
  bool forget_measurements = false, replace = false;
  StageChoices choices;
};

void add_calibrate_arguments(CLI::App& command, CalibrateArguments& arguments);

// Changes the project, in memory alone, as the arguments say: of measurements of the same points
// the new one counts. Throws CLI::ValidationError (bad usage) for what is written wrongly, Error
// for files that are no use.
void take_arguments(const CalibrateArguments& arguments, Project& project);

}  // namespace bosk
