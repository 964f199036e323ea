#include "core/project/session.h"

#include "core/base/error.h"
#include "core/project/project_json.h"

namespace bosk {
namespace {

ProjectLock lock_of(const std::filesystem::path& folder) {
  require_project(folder);
  return ProjectLock(folder);
}

std::string title_of(const Edit* edit) { return edit ? title(*edit) : std::string(); }

}  // namespace

Session::Session(const std::filesystem::path& folder)
    : lock_(lock_of(folder)), project_(read_saved_project(folder)), saved_(project_.journal) {
  Replay replay = replay_journal(project_);
  if (replay.end > 0) {
    history_ = std::move(replay.history);
  } else {
    start_journal(project_);
    saved_ = project_.journal;
  }
  journal_ = std::make_unique<JournalWriter>(folder, project_.journal);
}

Session::~Session() {
  try {
    save();
  } catch (const Error&) {
    // The journal has what project.json could not take
  }
}

void Session::apply(Edit edit) { take({StepKind::edit, checked_edit(std::move(edit), project_)}); }

std::string Session::undo_title() const { return title_of(edit_to_undo(history_)); }
std::string Session::redo_title() const { return title_of(edit_to_redo(history_)); }

void Session::undo() {
  if (can_undo()) take({StepKind::undo, {}});
}

void Session::redo() {
  if (can_redo()) take({StepKind::redo, {}});
}

void Session::save() {
  if (is_saved()) return;
  journal_->sync();
  save_project(project_);
  saved_ = project_.journal;
}

void Session::take(Step step) {
  const Edit* edit = step.kind == StepKind::edit ? &step.edit : nullptr;
  project_.journal.end = journal_->append(step.kind, edit);
  change_project(history_, step, project_);
  take_step(history_, std::move(step));
  ++revision_;
}

}  // namespace bosk
