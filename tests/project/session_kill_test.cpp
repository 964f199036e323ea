// A process that draws is killed with no warning: what it was told is kept must be there.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "core/project/session.h"
#include "tests/base/scratch_folder.h"
#include "tests/project/random_edits.h"

namespace bosk {
namespace {

constexpr int kKills = 20;

Stroke stroke_of(std::uint32_t number) {
  return {StrokeKind::foreground, 4.0, {{double(number), 0.0}, {double(number), 9.0}}};
}

// Draws for ever, and names each stroke on the pipe once it is kept; saves now and then.
[[noreturn]] void draw_until_killed(const std::filesystem::path& folder, int pipe) {
  try {
    Session session(folder);
    const auto drawn = session.project().strokes.find("oak_01");
    auto number =
        std::uint32_t(drawn == session.project().strokes.end() ? 0 : drawn->second.size());
    for (;; ++number) {
      session.apply(AddStroke{"oak_01", stroke_of(number)});
      if (::write(pipe, &number, sizeof(number)) != sizeof(number)) break;
      if (number % 40 == 39) session.save();
    }
  } catch (const std::exception&) {
  }
  ::_exit(1);
}

// Starts the process, lets it name so many strokes and kills it; the last number that it named.
std::uint32_t last_before_kill(const std::filesystem::path& folder, int strokes) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(pipe[0]);
    draw_until_killed(folder, pipe[1]);
  }
  ::close(pipe[1]);
  std::uint32_t number = 0, last = 0;
  const auto next = [&] { return ::read(pipe[0], &number, sizeof(number)) == sizeof(number); };
  for (int i = 0; i < strokes && next(); ++i) last = number;
  ::kill(child, SIGKILL);
  while (next()) last = number;  // named between our last look and the kill
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(pipe[0]);
  EXPECT_TRUE(WIFSIGNALED(status)) << "ended by itself, with status " << status;
  return last;
}

TEST(KilledSession, KeepsEveryStrokeThatItAcknowledged) {
  const ScratchFolder folder;
  saved_project(folder.path());
  Random random(9);
  for (int kill = 0; kill < kKills; ++kill) {
    const std::uint32_t last = last_before_kill(folder.path(), 1 + int(random.below(200)));
    const std::vector<Stroke> drawn = read_project(folder.path()).strokes.at("oak_01");
    // One more may have been kept that the process could not name any more
    ASSERT_GE(drawn.size(), last + 1) << kill;
    ASSERT_LE(drawn.size(), last + 2) << kill;
    for (std::uint32_t i = 0; i < drawn.size(); ++i) ASSERT_EQ(drawn[i], stroke_of(i)) << kill;
  }
  Session session(folder.path());
  const std::size_t all = session.project().strokes.at("oak_01").size();
  std::size_t undone = 0;
  for (; session.can_undo(); ++undone) session.undo();
  EXPECT_EQ(undone, all);
}

}  // namespace
}  // namespace bosk
