#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "core/project/history.h"
#include "core/project/project.h"

namespace bosk {

// FOLDER/edits.journal, little-endian, only ever appended to:
//
//   [magic "BOSKEDIT" 8 B][id 8 B]
//   [length u32][step u32][checksum u64][payload: length B] ...
//
// id: as project.json names it; a journal of another id is not this project's. step: StepKind; an
// edit's payload is in edit_bytes.h, undo and redo have none. checksum: XXH3 over id, place of the
// record, length, step and payload. The first record that is cut, damaged or impossible ends it.

std::filesystem::path journal_file(const std::filesystem::path& folder);

// What a journal tells beside the project.
struct Replay {
  History history;
  std::uint64_t end = 0;  // of the last sound record; 0: no journal to go on with
};

// Takes the project, as project.json has it, through what the journal holds beyond project.journal,
// and moves that to the end. Never fails: without a sound journal of the project's id it does
// nothing. Where the journal is damaged before that place, the steps behind it still count, but
// there is no history and no journal to go on with.
Replay replay_journal(Project& project);
// The same without the history; quick where there is nothing beyond project.journal.
void catch_up(Project& project);

// Appends to a journal. Whoever holds one holds the project's lock.
class JournalWriter {
 public:
  // Goes on behind `place.end`; what follows there is dropped. Throws Error.
  JournalWriter(const std::filesystem::path& folder, const JournalPlace& place);
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  // With the system before it returns (safe from a kill), on disk within a second. `edit` is null
  // for undo and redo. Returns the journal's new end. Throws Error, and what was there stands, when
  // it can't be written or the edit is larger than 256 MiB.
  std::uint64_t append(StepKind kind, const Edit* edit);
  // On disk now. Throws Error, also when an earlier attempt in the background failed.
  void sync();

 private:
  struct Syncer;
  std::filesystem::path path_;
  JournalPlace place_;
  std::unique_ptr<Syncer> syncer_;
};

// A new, empty journal, for a project that has none or whose journal can't be gone on with: writes
// project.json first, naming it, so that the project is whole by itself, then sets what was there
// aside as edits.journal.old. Sets project.journal. Throws Error.
void start_journal(Project& project);

}  // namespace bosk
