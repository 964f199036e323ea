#include "core/project/history.h"

#include <cassert>

#include "core/base/error.h"

namespace bosk {

const Edit* edit_to_undo(const History& history) {
  return history.done > 0 ? &history.edits[history.done - 1] : nullptr;
}

const Edit* edit_to_redo(const History& history) {
  return history.done < history.edits.size() ? &history.edits[history.done] : nullptr;
}

bool is_possible(const History& history, StepKind kind) {
  if (kind == StepKind::undo) return edit_to_undo(history) != nullptr;
  return kind == StepKind::edit || edit_to_redo(history) != nullptr;
}

void take_step(History& history, Step step) {
  assert(is_possible(history, step.kind));
  if (step.kind == StepKind::undo) {
    --history.done;
  } else if (step.kind == StepKind::redo) {
    ++history.done;
  } else {
    history.edits.resize(history.done);
    history.edits.push_back(std::move(step.edit));
    ++history.done;
  }
}

void change_project(const History& history, const Step& step, Project& project) {
  assert(is_possible(history, step.kind));
  try {
    if (step.kind == StepKind::undo) {
      revert(*edit_to_undo(history), project);
    } else {
      apply(step.kind == StepKind::edit ? step.edit : *edit_to_redo(history), project);
    }
  } catch (const Error&) {
    // Of an option that this Bosk doesn't have, or not with this value: nothing to change
  }
}

}  // namespace bosk
