#include "core/project/journal.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <array>
#include <cstring>
#include <optional>
#include <random>

#include "core/base/atomic_file.h"
#include "core/base/binary.h"
#include "core/base/file_descriptor.h"
#include "core/base/system_error.h"
#include "core/project/edit_bytes.h"
#include "core/project/journal_record.h"

namespace bosk {
namespace fs = std::filesystem;
namespace {

struct OpenJournal {
  FileDescriptor file;
  std::uint64_t id = 0, size = 0;
};

bool read_at(int file, std::uint64_t place, std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(file, bytes.data(), bytes.size(), off_t(place));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(std::size_t(got));
    place += std::uint64_t(got);
  }
  return true;
}

// The project's journal; none where there is no sound beginning of one with its id.
std::optional<OpenJournal> open_journal(const Project& project) {
  if (project.journal.id == 0) return std::nullopt;
  OpenJournal journal;
  journal.file = FileDescriptor(
      ::open(journal_file(project.folder).c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (!journal.file || ::fstat(journal.file.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    return std::nullopt;
  }
  std::array<std::byte, kJournalHeaderBytes> header{};
  if (!read_at(journal.file.get(), 0, header)) return std::nullopt;
  if (std::memcmp(header.data(), kJournalMagic.data(), kJournalMagic.size()) != 0) {
    return std::nullopt;
  }
  std::memcpy(&journal.id, header.data() + kJournalMagic.size(), sizeof(journal.id));
  journal.size = std::uint64_t(status.st_size);
  if (journal.id != project.journal.id) return std::nullopt;
  return journal;
}

struct Record {
  Step step;
  std::uint64_t end = 0;
};

// None where the bytes at the place are no whole, sound record.
std::optional<Record> record_at(const OpenJournal& journal, std::uint64_t place) {
  RecordHead head;
  std::array<std::byte, kRecordHeadBytes> head_bytes{};
  if (!read_at(journal.file.get(), place, head_bytes)) return std::nullopt;
  std::memcpy(&head, head_bytes.data(), sizeof(head));
  const std::uint64_t start = place + kRecordHeadBytes;
  if (head.length > kMaxRecordBytes || head.length > journal.size - start) return std::nullopt;
  std::vector<std::byte> payload(head.length);
  if (!read_at(journal.file.get(), start, payload)) return std::nullopt;
  if (head.checksum != record_checksum(journal.id, place, head, payload)) return std::nullopt;
  Record record{{StepKind(head.step), {}}, start + head.length};
  if (head.step > std::uint32_t(StepKind::redo)) return std::nullopt;
  if (record.step.kind != StepKind::edit)
    return head.length == 0 ? std::optional(record) : std::nullopt;
  try {
    record.step.edit = edit_of_bytes(payload);
  } catch (const Error&) {
    return std::nullopt;
  }
  return record;
}

// From the place on as far as it is sound; what lies beyond project.journal.end changes the
// project.
Replay walk(const OpenJournal& journal, std::uint64_t place, Project& project) {
  Replay replay;
  while (place <= journal.size && journal.size - place >= kRecordHeadBytes) {
    auto record = record_at(journal, place);
    if (!record || !is_possible(replay.history, record->step.kind)) break;
    if (place >= project.journal.end) change_project(replay.history, record->step, project);
    take_step(replay.history, std::move(record->step));
    place = record->end;
  }
  replay.end = place;
  return replay;
}

std::uint64_t random_id() {
  std::random_device device;
  const std::uint64_t id = (std::uint64_t(device()) << 32) | device();
  return id == 0 ? 1 : id;
}

// Whatever lies at the journal's place gives way; if it may hold edits, it is kept.
void set_aside(const fs::path& file) {
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0) return;
  if (S_ISREG(status.st_mode) && std::uint64_t(status.st_size) <= kJournalHeaderBytes) return;
  const fs::path aside = file.string() + ".old";
  if (::rename(file.c_str(), aside.c_str()) != 0) throw system_error(aside, "replaced", errno);
}

}  // namespace

fs::path journal_file(const fs::path& folder) { return folder / "edits.journal"; }

Replay replay_journal(Project& project) {
  const auto journal = open_journal(project);
  if (!journal) return {};
  Replay replay = walk(*journal, kJournalHeaderBytes, project);
  if (replay.end >= project.journal.end) {
    project.journal.end = replay.end;
    return replay;
  }
  // Damaged in what project.json holds already: only what follows is of use
  project.journal.end = walk(*journal, project.journal.end, project).end;
  return {};
}

void catch_up(Project& project) {
  std::error_code failure;
  const auto size = fs::file_size(journal_file(project.folder), failure);
  if (!failure && size > project.journal.end) replay_journal(project);
}

void start_journal(Project& project) {
  const fs::path file = journal_file(project.folder);
  project.journal = {random_id(), kJournalHeaderBytes};
  save_project(project);
  set_aside(file);
  BinaryWriter header;
  header.value(kJournalMagic);
  header.value(project.journal.id);
  write_file_atomically(file, header.bytes());
}

}  // namespace bosk
