#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/project/edit.h"

namespace bosk {

// The edits of a project, oldest first: the first `done` are in force, the rest can be redone.
struct History {
  std::vector<Edit> edits;
  std::size_t done = 0;
};

// What a journal's records say.
enum class StepKind : std::uint8_t { edit, undo, redo };
struct Step {
  StepKind kind = StepKind::edit;
  Edit edit;  // of an edit only
};

// The edit that undo or redo concerns; null when there is none.
const Edit* edit_to_undo(const History& history);
const Edit* edit_to_redo(const History& history);

// Whether the step is possible: undo and redo need an edit.
bool is_possible(const History& history, StepKind kind);
// Takes the step in the history alone. The step must be possible.
void take_step(History& history, Step step);
// What the step does to the project, before it is taken. An edit that doesn't fit is passed over.
void change_project(const History& history, const Step& step, Project& project);

}  // namespace bosk
