#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/project/edit.h"
#include "core/project/history.h"
#include "core/project/journal.h"
#include "core/project/lock.h"
#include "core/project/project.h"

namespace bosk {

// A project that is being worked on: the only way to change it while it is open. Holds the
// project's lock, so stages are run on it by this process alone (run_stages takes no lock). Each
// step is in the journal (journal.h) before the call returns, so a killed process loses none; after
// a power cut up to a second may be missing. Undo is unlimited and outlives the session. Of one
// thread; workers get copies of project().
class Session {
 public:
  // Opens the project with all that its journal holds. Throws Error when there is none, it is
  // damaged, another process works on it (kind temporary), or the folder can't be written.
  explicit Session(const std::filesystem::path& folder);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  // Saves; what then fails is lost to nobody, the journal holds it.
  ~Session();

  const Project& project() const { return project_; }

  // Changes the project and forgets what could be redone. Throws Error, and changes nothing, when
  // the edit doesn't fit (see apply), a text is not valid UTF-8, or the journal can't be written.
  void apply(Edit edit);

  bool can_undo() const { return edit_to_undo(history_) != nullptr; }
  bool can_redo() const { return edit_to_redo(history_) != nullptr; }
  // What undo or redo would concern; empty when there is nothing.
  std::string undo_title() const;
  std::string redo_title() const;
  // One step back or forth; nothing when there is none. An edit that no longer fits (an option that
  // this Bosk doesn't have) is passed without effect. Throws Error, and changes nothing, when the
  // journal can't be written.
  void undo();
  void redo();

  // Raised by every apply, undo and redo; 0 on opening.
  std::uint64_t revision() const { return revision_; }

  // Whether project.json holds all edits by itself.
  bool is_saved() const { return saved_ == project_.journal; }
  // Writes project.json, atomically; nothing when it is saved. Throws Error. Takes the disk's time
  // (it syncs); a worker may call save_project on a copy of project() instead, at any time, and
  // hand back what the copy's `journal` says.
  void save();
  void note_saved(const JournalPlace& place) { saved_ = place; }

 private:
  void take(Step step);

  ProjectLock lock_;
  Project project_;
  History history_;
  std::unique_ptr<JournalWriter> journal_;
  JournalPlace saved_;
  std::uint64_t revision_ = 0;
};

}  // namespace bosk
