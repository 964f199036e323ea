#pragma once

#include <memory>
#include <string>

#include "core/base/content_hash.h"
#include "core/project/evaluation.h"

namespace bosk {

struct Workspace;

// Scores on photos that were held out.
struct HeldOutState {
  int every = 6;
  int job = 0;
  std::shared_ptr<const Evaluation> evaluation;  // newest; null: none was made
  ContentHash of_package;  // the key of the package of all photos that it goes with
};

// Whether the newest scores are of the project as it is.
bool is_held_out_current(const Workspace& workspace);

// Why they can't be made now; empty when they can.
std::string obstacle_to_scoring(const Workspace& workspace);

// Leaves every n-th photo out of all stages, as `bosk evaluate --hold-out` does, in a job.
void start_held_out_scoring(Workspace& workspace);

// The action and the table of its result.
void draw_held_out(Workspace& workspace);

}  // namespace bosk
