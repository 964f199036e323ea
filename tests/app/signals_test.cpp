// Cancelling by a signal: the status says so, and what was finished is kept.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

bool has_entry(const fs::path& project, const std::string& stage) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(project / "cache", none)) {
    if (entry.path().filename().string().rfind(stage + "-", 0) == 0) return true;
  }
  return false;
}

// Starts a long run, sends the signal once the mattes are stored, and waits.
ProgramEnd cancelled_run(const fs::path& folder, int signal) {
  make_tiny_capture(folder / "capture");
  run_bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json", "--mattes",
            "capture/mattes", "--quiet"},
           folder);
  Program program({"run", "p", "-o", "t.bosk", "--radiance.epochs=50", "--opacity.finest_level=8"},
                  folder);
  while (program.is_running() && !has_entry(folder / "p", "matte")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send(signal);
  return program.wait();
}

TEST(Signals, InterruptEndsWith130AndKeepsFinishedStages) {
  const ScratchFolder folder;
  const ProgramEnd end = cancelled_run(folder.path(), SIGINT);
  EXPECT_EQ(end.status, 130);
  EXPECT_THAT(end.err, testing::HasSubstr("cancelled"));
  EXPECT_TRUE(has_entry(folder / "p", "matte"));
  EXPECT_FALSE(fs::exists(folder / "t.bosk"));
}

TEST(Signals, TerminateEndsWith143) {
  const ScratchFolder folder;
  EXPECT_EQ(cancelled_run(folder.path(), SIGTERM).status, 143);
}

TEST(Signals, ARunThatWasCancelledCanBeGoneOnWith) {
  const ScratchFolder folder;
  cancelled_run(folder.path(), SIGTERM);
  auto arguments = quick_options();
  arguments.insert(arguments.begin(),
                   {"run", "p", "-o", "t.bosk", "--quiet", "--radiance.epochs=1"});
  EXPECT_EQ(run_bosk(arguments, folder.path()).status, 0);
  EXPECT_TRUE(fs::exists(folder / "t.bosk"));
}

}  // namespace
}  // namespace bosk
