// A journal as an enemy or a bad disk leaves it: the project opens with a part of it, and can be
// worked on; never worse. BOSK_MUTATIONS sets how many.

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>

#include "core/base/error.h"
#include "core/project/edit_bytes.h"
#include "core/project/journal.h"
#include "core/project/journal_record.h"
#include "core/project/session.h"
#include "tests/base/scratch_folder.h"
#include "tests/hostile_input/mutate.h"
#include "tests/project/random_edits.h"

namespace bosk {
namespace {

int mutations(int usual) {
  const char* text = std::getenv("BOSK_MUTATIONS");
  return text != nullptr ? std::atoi(text) : usual;
}

void overwrite(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

// The journal of a session of some steps.
std::string made_journal(const std::filesystem::path& folder) {
  saved_project(folder);
  Session session(folder);
  Random random(12);
  for (int i = 0; i < 30; ++i) {
    session.apply(random_edit(random, session.project()));
    if (i % 4 == 0) session.undo();
    if (i % 8 == 0) session.redo();
  }
  return read_whole(folder / "edits.journal");
}

TEST(HostileJournal, OpensWithAPart) {
  const ScratchFolder folder;
  const std::string sound = made_journal(folder.path());
  Project project = read_project(folder.path());
  project.journal.end = 0;
  Random random(13);
  for (int i = 0; i < mutations(5000); ++i) {
    overwrite(folder / "edits.journal", mutated_bytes(random, sound));
    Project copy = project;
    const Replay replay = replay_journal(copy);
    ASSERT_LE(replay.history.done, replay.history.edits.size());
    ASSERT_LE(replay.history.edits.size(), 30u);
  }
}

// The same within a record's payload, with its checksum right: what a checksum lets through must do
// no harm either.
TEST(HostileJournal, RightChecksumsOverNonsenseDoNoHarm) {
  const ScratchFolder folder;
  made_journal(folder.path());
  Project project = read_project(folder.path());
  const std::string header = read_whole(folder / "edits.journal").substr(0, kJournalHeaderBytes);
  Random random(14);
  int taken = 0;
  for (int i = 0; i < mutations(5000); ++i) {
    const auto edit = bytes_of_edit(random_edit(random, project));
    const std::string payload =
        mutated_bytes(random, {reinterpret_cast<const char*>(edit.data()), edit.size()});
    RecordHead head{std::uint32_t(payload.size()), std::uint32_t(random.below(20) == 0 ? 7 : 0), 0};
    head.checksum = record_checksum(project.journal.id, kJournalHeaderBytes, head,
                                    std::as_bytes(std::span(payload)));
    std::string journal = header + std::string(sizeof(head), '\0') + payload;
    std::memcpy(journal.data() + header.size(), &head, sizeof(head));
    overwrite(folder / "edits.journal", journal);
    Project copy = project;
    copy.journal.end = 0;
    Replay replay = replay_journal(copy);
    if (replay.history.done == 0) continue;
    ++taken;
    change_project(replay.history, {StepKind::undo, {}}, copy);
    static_cast<void>(title(replay.history.edits.front()));
  }
  EXPECT_GT(taken, 0);  // another letter in a name: nobody can know
}

TEST(HostileJournal, HugeCountsAreNotBelieved) {
  for (std::uint8_t kind = 0; kind < 8; ++kind) {
    for (const std::uint64_t count : {~std::uint64_t(0), std::uint64_t(1) << 40}) {
      std::vector<std::byte> bytes(1 + 3 * sizeof(count));
      bytes[0] = std::byte(kind);
      for (std::size_t i = 0; i < 3; ++i) {
        std::memcpy(bytes.data() + 1 + i * sizeof(count), &count, sizeof(count));
      }
      EXPECT_THROW(edit_of_bytes(bytes), Error) << int(kind);
    }
  }
}

TEST(HostileJournal, APlaceFarBeyondTheEndIsNoPlace) {
  const ScratchFolder folder;
  made_journal(folder.path());
  Project project = read_project(folder.path());
  for (const std::uint64_t end : {~std::uint64_t(0), std::uint64_t(1) << 62, std::uint64_t(17)}) {
    project.journal.end = end;
    save_project(project);
    EXPECT_NO_THROW(read_project(folder.path()));
    EXPECT_NO_THROW(Session(folder.path()).apply(SetFiles{FileKind::mattes, "", "m"}));
  }
}

}  // namespace
}  // namespace bosk
