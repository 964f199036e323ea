#include "core/base/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

constexpr const char* kMode = "--test-child";

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

[[noreturn]] void spin() {
  for (std::atomic<int> turns{0};; ++turns) {
  }
}

// What the child does, by its first argument.
std::vector<std::byte> misbehave(const std::vector<std::string>& arguments) {
  const std::string& deed = arguments.at(0);
  if (deed == "echo") return bytes_of(arguments.at(1));
  if (deed == "big") return std::vector<std::byte>(std::size_t(20) << 20, std::byte(7));
  if (deed == "refuse") throw Error("no, because");
  if (deed == "crash") ::raise(SIGKILL);
  if (deed == "spin") spin();
  if (deed == "work") {
    const std::clock_t start = std::clock();
    while (std::clock() - start < CLOCKS_PER_SEC * 2 / 5) {
    }
  }
  if (deed == "remember") {
    const bool again = ::getenv("BOSK_TEST_REMAINS") != nullptr;
    ::setenv("BOSK_TEST_REMAINS", "1", 1);
    return bytes_of(again ? "again" : "first");
  }
  if (deed == "sleep") std::this_thread::sleep_for(std::chrono::hours(1));
  if (deed == "eat") {
    const auto food = std::make_unique<char[]>(std::size_t(8) << 30);
    std::memset(food.get(), 1, std::size_t(8) << 30);
  }
  if (deed == "write") {
    ::signal(SIGXFSZ, SIG_IGN);
    std::ofstream file(arguments.at(1));
    file << "trace" << std::flush;
    return bytes_of(file ? "written" : "stopped");
  }
  if (deed == "nest") ChildServer(kMode).run({"echo", "x"}, {}, Progress());
  return {};
}

ChildOutcome run(const std::vector<std::string>& arguments, const ChildLimits& limits = {}) {
  const Progress quiet;
  return ChildServer(kMode).run(arguments, limits, quiet);
}

TEST(ChildProcess, GivesItsResult) {
  const ChildOutcome outcome = run({"echo", "leaf \xc3\xa4 'quoted'"});
  EXPECT_EQ(outcome.end, ChildEnd::result);
  EXPECT_EQ(text_of(outcome.result), "leaf \xc3\xa4 'quoted'");
}

TEST(ChildProcess, GivesResultsLargerThanAPipeHolds) {
  const ChildOutcome outcome = run({"big"});
  ASSERT_EQ(outcome.result.size(), std::size_t(20) << 20);
  EXPECT_EQ(outcome.result.back(), std::byte(7));
}

TEST(ChildProcess, TellsWhyItRefuses) {
  const ChildOutcome outcome = run({"refuse"});
  EXPECT_EQ(outcome.end, ChildEnd::refused);
  EXPECT_EQ(outcome.reason, "no, because");
}

TEST(ChildProcess, MayCrash) {
  const ChildOutcome outcome = run({"crash"});
  EXPECT_EQ(outcome.end, ChildEnd::stopped);
  EXPECT_THAT(outcome.reason, testing::HasSubstr("crashed"));
}

TEST(ChildProcess, IsStoppedAtItsCpuTime) {
  EXPECT_EQ(run({"spin"}, {.cpu_s = 1.0}).end, ChildEnd::stopped);
}

TEST(ChildProcess, IsStoppedAtItsWallTime) {
  EXPECT_EQ(run({"sleep"}, {.wall_s = 0.3}).end, ChildEnd::timed_out);
}

TEST(ChildProcess, GetsNoMoreMemoryThanItsLimit) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs more addresses than any limit leaves";
#endif
  EXPECT_EQ(run({"eat"}).end, ChildEnd::refused);
}

TEST(ChildProcess, LeavesNoFiles) {
  const ScratchFolder folder;
  const ChildOutcome outcome = run({"write", (folder / "trace").string()});
  EXPECT_EQ(text_of(outcome.result), "stopped");
}

TEST(ChildProcess, SendsNoMoreThanItMay) {
  EXPECT_EQ(run({"big"}, {.result_bytes = 1000}).end, ChildEnd::stopped);
}

TEST(ChildProcess, StartsNoChildrenItself) { EXPECT_EQ(run({"nest"}).end, ChildEnd::refused); }

TEST(ChildProcess, GoesAwayWhenTheJobIsCancelled) {
  Progress progress;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    progress.cancel();
  });
  ChildServer server(kMode);
  EXPECT_THROW(server.run({"sleep"}, {}, progress), Cancelled);
  canceller.join();
}

TEST(ChildProcess, ServesOnWhateverBecameOfATask) {
  ChildServer server(kMode);
  const Progress quiet;
  for (const char* deed : {"refuse", "crash", "sleep", "big"}) {
    server.run({deed}, {.wall_s = 0.5, .result_bytes = 1000}, quiet);
    EXPECT_EQ(text_of(server.run({"echo", deed}, {}, quiet).result), deed);
  }
}

TEST(ChildProcess, GivesEachTaskItsOwnCpuTime) {
  ChildServer server(kMode);
  const Progress quiet;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(server.run({"work"}, {.cpu_s = 1.0}, quiet).end, ChildEnd::result);
  }
}

TEST(ChildProcess, HidesEachTaskFromTheNext) {
  ChildServer server(kMode);
  const Progress quiet;
  EXPECT_EQ(text_of(server.run({"remember"}, {}, quiet).result), "first");
  EXPECT_EQ(text_of(server.run({"remember"}, {}, quiet).result), "first");
}

TEST(ChildProcess, ServesManyThreadsAtOnce) {
  std::vector<std::string> answers(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    threads.emplace_back([&, i] { answers[i] = text_of(run({"echo", std::to_string(i)}).result); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < answers.size(); ++i) EXPECT_EQ(answers[i], std::to_string(i));
}

}  // namespace
}  // namespace bosk

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], bosk::kMode) == 0) {
    return bosk::serve_as_child(argc, argv, bosk::misbehave);
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
