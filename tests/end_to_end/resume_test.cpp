// kill -9 at any moment, then run again: the same package, bit for bit. BOSK_KILLS sets how many
// kills of each stage are tried (1 unless set; 20 for a long run).

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

int kills_per_stage() {
  const char* text = std::getenv("BOSK_KILLS");
  return text == nullptr ? 1 : std::max(1, std::atoi(text));
}

std::vector<std::string> new_arguments(const std::string& project) {
  std::vector<std::string> arguments = {
      "new",      project,          "capture/photos", "--cameras", "capture/transforms.json",
      "--mattes", "capture/mattes", "--pack.name=t",  "--quiet"};
  for (const std::string& option : quick_options()) arguments.push_back(option);
  return arguments;
}

bool is_stored(const fs::path& project, const std::string& stage) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(project / "cache", none)) {
    if (entry.path().filename().string().rfind(stage + "-", 0) == 0) return true;
  }
  return false;
}

void remove_stored(const fs::path& project, const std::string& stage) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(project / "cache")) {
    if (entry.path().filename().string().rfind(stage + "-", 0) == 0) found.push_back(entry.path());
  }
  for (const fs::path& path : found) fs::remove(path);
}

class Resume : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    make_tiny_capture(folder / "capture");
    ASSERT_EQ(run_bosk(new_arguments("whole"), folder.path()).status, 0);
    ASSERT_EQ(run_bosk({"run", "whole", "-o", "whole.bosk", "--quiet"}, folder.path()).status, 0);
    whole = content_of(folder / "whole.bosk");
  }

  // Starts the run with everything before the stage in the cache, and kills it after the time.
  void kill_in_stage(const std::string& stage, std::chrono::microseconds after) const {
    fs::remove_all(folder / "p");
    fs::copy(folder / "whole", folder / "p", fs::copy_options::recursive);
    bool later = false;
    for (const std::string name : {"matte", "opacity", "radiance", "texture", "compress", "pack"}) {
      later = later || name == stage;
      if (later) remove_stored(folder / "p", name);
    }
    fs::remove(folder / "t.bosk");
    Program program({"run", "p", "-o", "t.bosk", "--quiet"}, folder.path());
    std::this_thread::sleep_for(after);
    program.send(SIGKILL);
    program.wait();
  }

  ScratchFolder folder;
  std::string whole;
};

TEST_P(Resume, AfterAKillGivesTheSamePackage) {
  const std::string stage = GetParam();
  kill_in_stage(stage, std::chrono::microseconds(0));
  // How long the rest takes from here, the program's own start included
  const auto start = Clock::now();
  ASSERT_EQ(run_bosk({"run", "p", "-o", "t.bosk", "--quiet"}, folder.path()).status, 0);
  const auto rest = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start);
  EXPECT_EQ(content_of(folder / "t.bosk"), whole);

  std::minstd_rand random(7);
  for (int kill = 0; kill < kills_per_stage(); ++kill) {
    const double part = double(random()) / double(std::minstd_rand::max());
    kill_in_stage(stage, std::chrono::microseconds(long(part * double(rest.count()))));
    const ProgramEnd end = run_bosk({"run", "p", "-o", "t.bosk", "--quiet"}, folder.path());
    EXPECT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(content_of(folder / "t.bosk"), whole) << "killed after " << part << " of the rest";
    EXPECT_TRUE(is_stored(folder / "p", "pack"));
  }
}

INSTANTIATE_TEST_SUITE_P(EveryStage, Resume,
                         testing::Values("matte", "opacity", "radiance", "texture", "compress",
                                         "pack"),
                         [](const auto& stage) { return stage.param; });

}  // namespace
}  // namespace bosk
