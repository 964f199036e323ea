#include "core/project/session.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "core/base/error.h"
#include "core/project/journal.h"
#include "core/project/project_json.h"
#include "tests/base/scratch_folder.h"
#include "tests/hostile_input/mutate.h"
#include "tests/project/random_edits.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

Edit stroke_at(double x) {
  return AddStroke{"oak_01", {StrokeKind::foreground, 5.0, {{x, 1.0}, {x + 3.0, 9.0}}}};
}

void overwrite(const fs::path& path, const std::string& bytes) {
  fs::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

// The folder as a kill leaves it at this moment: what is in the files, nothing else.
void copy_as_killed(const fs::path& from, const fs::path& to) {
  fs::remove_all(to);
  fs::copy(from, to);
}

// What the two ends of a session's history look like, leaving it where it was.
struct HistoryEnds {
  std::string start, end;
  std::size_t steps_back = 0, steps_forth = 0;
  bool operator==(const HistoryEnds&) const = default;
};
HistoryEnds ends_of(Session& session) {
  HistoryEnds ends;
  for (; session.can_undo(); ++ends.steps_back) session.undo();
  ends.start = content_of(session.project());
  for (; session.can_redo(); ++ends.steps_forth) session.redo();
  ends.end = content_of(session.project());
  ends.steps_forth -= ends.steps_back;
  for (std::size_t i = 0; i < ends.steps_forth; ++i) session.undo();
  return ends;
}

TEST(Session, UndoesAndRedoesInOrder) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Session session(folder.path());
  EXPECT_FALSE(session.can_undo());
  EXPECT_EQ(session.undo_title(), "");
  const std::string start = content_of(session.project());
  session.apply(stroke_at(1));
  session.apply(option_edit(session.project(), "opacity.passes", "7"));
  EXPECT_EQ(session.undo_title(), "opacity.passes 1 to 7");
  session.undo();
  EXPECT_EQ(session.redo_title(), "opacity.passes 1 to 7");
  EXPECT_EQ(session.undo_title(), "stroke on oak_01");
  session.undo();
  EXPECT_EQ(content_of(session.project()), start);
  EXPECT_FALSE(session.can_undo());
  session.redo();
  session.apply(stroke_at(2));
  EXPECT_FALSE(session.can_redo());
  EXPECT_EQ(session.project().strokes.at("oak_01").size(), 2u);
}

TEST(Session, RaisesTheRevisionWithEveryStep) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Session session(folder.path());
  EXPECT_EQ(session.revision(), 0u);
  session.apply(stroke_at(1));
  session.undo();
  session.redo();
  EXPECT_EQ(session.revision(), 3u);
  session.redo();
  EXPECT_EQ(session.revision(), 3u);
}

TEST(Session, RefusesAnEditThatDoesNotFitAndGoesOn) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Session session(folder.path());
  session.apply(stroke_at(1));
  EXPECT_THROW(session.apply(SetOption{"opacity.passes", "1", "-4"}), Error);
  EXPECT_THROW(session.apply(AddStroke{"\xff", {StrokeKind::erase, 5.0, {{1.0, 1.0}}}}), Error);
  EXPECT_EQ(session.undo_title(), "stroke on oak_01");
  session.apply(stroke_at(2));
  EXPECT_EQ(read_project(folder.path()).strokes, session.project().strokes);
}

TEST(Session, KeepsOthersFromTheProject) {
  const ScratchFolder folder;
  saved_project(folder.path());
  {
    const Session session(folder.path());
    try {
      const Session second(folder.path());
      FAIL() << "opened twice";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::temporary);
    }
  }
  EXPECT_NO_THROW(Session(folder.path()));
}

TEST(Session, SaysWhenThereIsNoProject) {
  const ScratchFolder folder;
  EXPECT_THROW(Session(folder.path()), Error);
  EXPECT_THROW(Session(folder / "none"), Error);
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(Session, ReadersSeeEveryEditAtOnce) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Session session(folder.path());
  for (int i = 0; i < 20; ++i) {
    session.apply(stroke_at(i));
    if (i % 7 == 0) session.save();
    if (i % 3 == 0) session.undo();
    ASSERT_EQ(content_of(read_project(folder.path())), content_of(session.project())) << i;
  }
}

TEST(Session, IsSavedWhenProjectJsonHoldsAll) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Session session(folder.path());
  EXPECT_TRUE(session.is_saved());
  session.apply(stroke_at(1));
  EXPECT_FALSE(session.is_saved());
  EXPECT_TRUE(read_saved_project(folder.path()).strokes.empty());
  session.save();
  EXPECT_TRUE(session.is_saved());
  EXPECT_EQ(read_saved_project(folder.path()).strokes, session.project().strokes);
}

TEST(Session, ReopensAtAnyPointOfTenThousandRandomStepsAsItWas) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "oak");
  saved_project(scratch / "oak");
  std::optional<Session> session(scratch / "oak");
  const std::string start = content_of(session->project());
  Random random(1);
  for (int i = 1; i <= 10'000; ++i) {
    const auto die = random.below(20);
    if (die < 1) {
      for (auto left = 1 + random.below(8); left > 0; --left) session->undo();
    } else if (die < 2) {
      for (auto left = 1 + random.below(8); left > 0; --left) session->redo();
    } else {
      session->apply(random_edit(random, session->project()));
    }
    if (i % 1000 == 0) {
      copy_as_killed(scratch / "oak", scratch / "killed");
      Session reopened(scratch / "killed");
      ASSERT_EQ(content_of(reopened.project()), content_of(session->project()));
      ASSERT_EQ(ends_of(reopened), ends_of(*session));
    }
    if (random.below(500) == 0) session->save();
    if (random.below(800) == 0) {
      const std::string content = content_of(session->project());
      session.reset();
      session.emplace(scratch / "oak");
      ASSERT_EQ(content_of(session->project()), content);
    }
  }
  while (session->can_redo()) session->redo();
  const std::string end = content_of(session->project());
  const HistoryEnds ends = ends_of(*session);
  EXPECT_EQ(ends.start, start);
  EXPECT_EQ(ends.end, end);
  EXPECT_GT(ends.steps_back, 1000u);
}

TEST(Session, GoesOnAfterTheCommandLineChangedTheProject) {
  const ScratchFolder folder;
  saved_project(folder.path());
  {
    Session session(folder.path());
    session.apply(stroke_at(1));
    session.apply(option_edit(session.project(), "opacity.passes", "7"));
  }
  Project project = read_project(folder.path());
  set_option(project.recipe, "opacity.passes", "9");
  set_option(project.recipe, "pack.licence", "CC0");
  save_project(project);

  Session session(folder.path());
  EXPECT_EQ(session.project().recipe.opacity.passes, 9);
  EXPECT_EQ(session.undo_title(), "opacity.passes 1 to 7");
  session.undo();
  EXPECT_EQ(session.project().recipe.opacity.passes, 1);
  EXPECT_EQ(session.project().recipe.pack.licence, "CC0");
  session.undo();
  EXPECT_TRUE(session.project().strokes.empty());
  session.redo();
  session.redo();
  EXPECT_EQ(session.project().recipe.opacity.passes, 7);
  EXPECT_EQ(content_of(read_project(folder.path())), content_of(session.project()));
}

TEST(Session, AProjectDescribedAnewBeginsAnewAndTheJournalIsSetAside) {
  const ScratchFolder folder;
  const Project before = saved_project(folder.path());
  {
    Session session(folder.path());
    session.apply(stroke_at(1));
  }
  save_project(before);  // as if made anew: it names no journal
  EXPECT_TRUE(read_project(folder.path()).strokes.empty());
  Session session(folder.path());
  EXPECT_FALSE(session.can_undo());
  EXPECT_TRUE(session.project().strokes.empty());
  EXPECT_TRUE(fs::exists(folder / "edits.journal.old"));
  session.apply(stroke_at(2));
  EXPECT_EQ(read_project(folder.path()).strokes, session.project().strokes);
}

// Where each record of a journal ends.
std::vector<std::size_t> record_ends(const std::string& journal) {
  std::vector<std::size_t> ends = {16};
  while (ends.back() < journal.size()) {
    std::uint32_t length = 0;
    std::memcpy(&length, journal.data() + ends.back(), sizeof(length));
    ends.push_back(ends.back() + 16 + length);
  }
  return ends;
}

struct SmallJournal {
  std::string project, journal;
  std::vector<std::string> contents;  // after each record
};
SmallJournal small_journal() {
  const ScratchFolder folder;
  saved_project(folder.path());
  SmallJournal small;
  Session session(folder.path());
  small.project = read_whole(folder / "project.json");
  small.contents.push_back(content_of(session.project()));
  const auto after = [&] { small.contents.push_back(content_of(session.project())); };
  session.apply(stroke_at(1)), after();
  session.apply(option_edit(session.project(), "opacity.passes", "7")), after();
  session.undo(), after();
  session.redo(), after();
  session.apply(clear_edit(session.project(), "oak_01")), after();
  small.journal = read_whole(folder / "edits.journal");
  return small;
}

TEST(Session, DamageAtAnyByteKeepsWhatIsBeforeIt) {
  const ScratchFolder folder;
  const SmallJournal small = small_journal();
  const auto ends = record_ends(small.journal);
  ASSERT_EQ(ends.size(), small.contents.size());
  for (std::size_t i = 0; i < small.journal.size(); ++i) {
    std::string damaged = small.journal;
    damaged[i] = char(damaged[i] ^ (1 << (i % 8)));
    overwrite(folder / "project.json", small.project);
    overwrite(folder / "edits.journal", damaged);
    const auto sound = std::upper_bound(ends.begin(), ends.end(), i) - ends.begin();
    const std::string& expected =
        small.contents[std::size_t(std::max<std::ptrdiff_t>(sound, 1)) - 1];
    ASSERT_EQ(content_of(read_project(folder.path())), expected) << i;
    if (i % 8 != 0) continue;  // opening for writing takes the disk's time
    Session session(folder.path());
    ASSERT_EQ(content_of(session.project()), expected) << i;
    session.apply(stroke_at(77));
    ASSERT_EQ(content_of(read_project(folder.path())), content_of(session.project())) << i;
  }
}

TEST(Session, ACutAtAnyByteKeepsWhatIsBeforeIt) {
  const ScratchFolder folder;
  const SmallJournal small = small_journal();
  const auto ends = record_ends(small.journal);
  for (std::size_t size = 0; size <= small.journal.size(); ++size) {
    overwrite(folder / "project.json", small.project);
    overwrite(folder / "edits.journal", small.journal.substr(0, size));
    const auto whole = std::upper_bound(ends.begin(), ends.end(), size) - ends.begin();
    const std::string& expected =
        small.contents[std::size_t(std::max<std::ptrdiff_t>(whole, 1)) - 1];
    ASSERT_EQ(content_of(read_project(folder.path())), expected) << size;
    if (size % 8 != 0) continue;
    Session session(folder.path());
    ASSERT_EQ(content_of(session.project()), expected) << size;
    session.apply(stroke_at(77));
    ASSERT_EQ(content_of(read_project(folder.path())), content_of(session.project())) << size;
  }
}

TEST(Session, DamageInWhatIsSavedLosesTheHistoryAlone) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "oak");
  saved_project(scratch / "oak");
  Session session(scratch / "oak");
  session.apply(stroke_at(1));
  const auto saved_bytes = fs::file_size(scratch / "oak" / "edits.journal");
  session.save();
  session.apply(stroke_at(2));
  session.apply(option_edit(session.project(), "opacity.passes", "7"));
  const std::string sound = read_whole(scratch / "oak" / "edits.journal");
  for (std::size_t i = 16; i < saved_bytes; i += 5) {
    copy_as_killed(scratch / "oak", scratch / "killed");
    std::string damaged = sound;
    damaged[i] = char(damaged[i] ^ 0x10);
    overwrite(scratch / "killed" / "edits.journal", damaged);
    Session reopened(scratch / "killed");
    ASSERT_EQ(content_of(reopened.project()), content_of(session.project())) << i;
    ASSERT_FALSE(reopened.can_undo());
    ASSERT_TRUE(fs::exists(scratch / "killed" / "edits.journal.old"));
    ASSERT_EQ(content_of(read_project(scratch / "killed")), content_of(session.project())) << i;
  }
}

TEST(Session, ALostJournalLosesTheHistoryAlone) {
  const ScratchFolder folder;
  saved_project(folder.path());
  std::string content;
  {
    Session session(folder.path());
    session.apply(stroke_at(1));
    content = content_of(session.project());
  }
  fs::remove(folder / "edits.journal");
  Session session(folder.path());
  EXPECT_EQ(content_of(session.project()), content);
  EXPECT_FALSE(session.can_undo());
}

TEST(Session, ALinkInTheJournalsPlaceIsNotFollowed) {
  const ScratchFolder folder;
  saved_project(folder.path());
  overwrite(folder / "precious", "short");
  fs::create_symlink(folder / "precious", folder / "edits.journal");
  Session session(folder.path());
  session.apply(stroke_at(1));
  EXPECT_EQ(read_whole(folder / "precious"), "short");
}

}  // namespace
}  // namespace bosk
