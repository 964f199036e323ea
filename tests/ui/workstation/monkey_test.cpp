#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "core/base/random.h"
#include "core/project/project_json.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/hand.h"
#include "tests/ui/workstation/tiny_project.h"
#include "ui/widgets/keys.h"

namespace bosk {
namespace {

double seconds_of_play() {
  const char* asked = std::getenv("BOSK_MONKEY_S");
  return asked ? std::atof(asked) : 5.0;
}

ImVec2 somewhere(Random& random, const ImVec2& size) {
  return {float(random.uniform(0.0, double(size.x))), float(random.uniform(0.0, double(size.y)))};
}

// A landmark that is there now, but for the ones that would end the play.
std::string some_landmark(Random& random, Workspace& workspace) {
  std::vector<std::string> names;
  for (const auto& [name, mark] : workspace.landmarks) {
    if (name != "close") names.push_back(name);
  }
  return names.empty() ? "" : names[random.below(names.size())];
}

void do_something(Hand& hand, Random& random) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  static constexpr int kKeys[] = {'Z',       'Y',        'F',           'X',       'E',
                                  'B',       'P',        ' ',           '[',       ']',
                                  kKeyHome,  kKeyEscape, kKeyF1,        kKeyEnter, kKeyTab,
                                  kKeyLeft,  kKeyRight,  kKeyUp,        kKeyDown,  kKeyDelete,
                                  kKeyEqual, kKeyMinus,  kKeyBackspace, '1',       '5'};
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2: {
      const std::string name = some_landmark(random, hand.workspace());
      if (!name.empty()) hand.click(name, random.below(10) == 0 ? 1 : 0);
      break;
    }
    case 3:
      hand.drag(somewhere(random, size), somewhere(random, size), 1 + int(random.below(12)),
                int(random.below(3)));
      break;
    case 4:
      hand.key(kKeys[random.below(std::size(kKeys))], random.below(3) == 0, random.below(3) == 0,
               random.below(6) == 0);
      break;
    case 5:
      hand.move_to(somewhere(random, size));
      hand.wheel(float(random.uniform(-3.0, 3.0)));
      break;
    case 6:
      hand.type(std::string(1 + random.below(4), char(32 + random.below(95))));
      break;
    default:
      hand.frame(1 + int(random.below(5)));
  }
}

// Plays for a while with the open project. False where it ended up without one.
bool play(Hand& hand, std::uint64_t seed) {
  Random random(seed);
  const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> length(seconds_of_play());
  while (hand.workspace().session && std::chrono::steady_clock::now() - start < length) {
    do_something(hand, random);
  }
  hand.workspace().jobs.cancel_all();
  hand.hold_modifiers(false, false, false);
  return hand.settle() && hand.workspace().session;
}

std::string content_of(const Workspace& workspace) {
  Project project = workspace.project();
  project.journal = {};
  return project_text(project);
}

// Undone to the first edit and redone to the last, twice: both ends are always the same.
void expect_the_same_ends(Workspace& workspace, const std::string& first) {
  while (workspace.session->can_redo()) redo(workspace);  // what the play left undone
  const std::string last = content_of(workspace);
  for (int round = 0; round < 2; ++round) {
    while (workspace.session->can_undo()) undo(workspace);
    EXPECT_EQ(content_of(workspace), first);
    while (workspace.session->can_redo()) redo(workspace);
    EXPECT_EQ(content_of(workspace), last);
  }
}

TEST(Monkey, RandomInputBreaksNothingInAnEmptyProject) {
  const ScratchFolder scratch;
  Hand hand;
  hand.click("start/folder");
  hand.type((scratch.path() / "oak").string());
  hand.click("start/make");
  ASSERT_TRUE(hand.workspace().session);
  const std::string first = content_of(hand.workspace());
  ASSERT_TRUE(play(hand, 20261127));
  expect_the_same_ends(hand.workspace(), first);
}

TEST(Monkey, RandomInputBreaksNothingFromPhotosToPackage) {
  const ScratchFolder scratch;
  const Project project = make_tiny_project(scratch.path(), TinyStart::scribbles);
  const std::string folder = project.folder.string();
  Hand hand;
  open_project(hand.workspace(), folder);
  hand.settle();
  const std::string first = content_of(hand.workspace());
  ASSERT_TRUE(play(hand, 7));
  ASSERT_EQ(hand.workspace().project().folder.string(), folder);
  expect_the_same_ends(hand.workspace(), first);
}

}  // namespace
}  // namespace bosk
