// project.json as an enemy or a bad disk leaves it: read or refused in words, never worse.

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/project/project.h"
#include "tests/base/scratch_folder.h"
#include "tests/hostile_input/mutate.h"

namespace bosk {
namespace {

constexpr int kMutations = 5000;

void overwrite(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::remove(path);  // a file cut to nothing first is synced by some systems, and slow
  std::ofstream(path, std::ios::binary) << text;
}

// Whether it was refused.
bool is_refused(const std::filesystem::path& folder) {
  try {
    read_project(folder);
    return false;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("project.json"), std::string::npos) << error.what();
    return true;
  }
}

TEST(HostileProject, IsReadOrRefusedInWords) {
  const ScratchFolder folder;
  Project project;
  project.folder = folder.path();
  project.photos = {"../a.jpg", "../b.jpg"};
  project.cameras = "../transforms.json";
  save_project(project);
  const std::string sound = read_whole(folder / "project.json");
  Random random(11);
  int refused = 0;
  for (int i = 0; i < kMutations; ++i) {
    const bool as_text = i % 2 == 0;
    overwrite(folder / "project.json",
              as_text ? mutated_text(random, sound) : mutated_bytes(random, sound));
    refused += is_refused(folder.path()) ? 1 : 0;
  }
  // A changed digit or letter of a path may well be sound; most injuries are not
  EXPECT_GT(refused, kMutations / 2);
  EXPECT_EQ(folder.file_count(), 1u);
}

}  // namespace
}  // namespace bosk
