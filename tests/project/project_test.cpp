#include "core/project/project.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

Project some_project(const fs::path& folder) {
  Project project;
  project.folder = folder;
  project.photos = {"../photos/a b.jpg", "../photos/\xc3\xa4.jpg"};
  project.cameras = "../transforms.json";
  project.mattes = "../mattes";
  project.recipe.opacity.passes = 3;
  project.recipe.pack.name = "a \"tree\"";
  return project;
}

std::string text_of(const fs::path& path) {
  const auto bytes = read_file(path, 1 << 20);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string refusal(const fs::path& folder) {
  try {
    read_project(folder);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return error.what();
  }
  return "";
}

// Saves a project, replaces the first `old` in its file by `fresh`, and says why it is refused.
std::string refusal_after(const std::string& old, const std::string& fresh) {
  const ScratchFolder folder;
  save_project(some_project(folder.path()));
  std::string text = text_of(folder / "project.json");
  const std::size_t place = text.find(old);
  if (place == std::string::npos) return "no \"" + old + "\" in the file";
  write_file_atomically(folder / "project.json", text.replace(place, old.size(), fresh));
  return refusal(folder.path());
}

TEST(Project, ReadsBackWhatItSaved) {
  const ScratchFolder folder;
  const Project saved = some_project(folder.path());
  save_project(saved);
  const Project read = read_project(folder.path());
  EXPECT_EQ(read.photos, saved.photos);
  EXPECT_EQ(read.cameras, saved.cameras);
  EXPECT_EQ(read.mattes, saved.mattes);
  EXPECT_EQ(read.scribbles, saved.scribbles);
  EXPECT_EQ(read.recipe.opacity.passes, 3);
  EXPECT_EQ(read.recipe.pack.name, "a \"tree\"");
}

TEST(Project, LeavesTheFileAloneWhenNothingChanged) {
  const ScratchFolder folder;
  save_project(some_project(folder.path()));
  const auto before = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder / "project.json", before);
  save_project(read_project(folder.path()));
  EXPECT_EQ(fs::last_write_time(folder / "project.json"), before);
}

TEST(Project, RefusesAMissingFolderAndOneWithoutAProject) {
  const ScratchFolder folder;
  EXPECT_NE(refusal(folder / "none").find("no such folder"), std::string::npos);
  EXPECT_NE(refusal(folder.path()).find("holds no project"), std::string::npos);
}

TEST(Project, RefusesDamagedFiles) {
  EXPECT_NE(refusal_after("{", "").find("no valid JSON"), std::string::npos);
  EXPECT_NE(refusal_after("\"bosk_project\"", "\"other\"").find("no project of Bosk"),
            std::string::npos);
  EXPECT_NE(refusal_after("\"photos\"", "\"fotos\"").find("missing"), std::string::npos);
  EXPECT_NE(refusal_after("\"cameras\": \"", "\"cameras\": 3, \"x\": \"").find("wrong kind"),
            std::string::npos);
  const std::string deep(100, '[');
  EXPECT_NE(refusal_after("\"photos\": [", "\"photos\": " + deep).find("damaged"),
            std::string::npos);
}

TEST(Project, RefusesOptionsThatDontExistOrDontFit) {
  EXPECT_NE(refusal_after("\"passes\"", "\"passages\"").find("passages"), std::string::npos);
  EXPECT_NE(refusal_after("\"passes\": 3", "\"passes\": -3").find("opacity.passes"),
            std::string::npos);
}

TEST(Project, PolitelyRefusesANewerVersion) {
  EXPECT_NE(refusal_after("\"bosk_project\": 1", "\"bosk_project\": 5").find("newer Bosk"),
            std::string::npos);
}

TEST(Project, RefusesNamesThatAreNotUtf8AndKeepsTheOldFile) {
  const ScratchFolder folder;
  save_project(some_project(folder.path()));
  const std::string before = text_of(folder / "project.json");
  Project project = some_project(folder.path());
  project.photos.push_back("\xff.jpg");
  EXPECT_THROW(save_project(project), Error);
  EXPECT_EQ(text_of(folder / "project.json"), before);
}

TEST(Project, IsNamedAsItsFolder) {
  EXPECT_EQ(some_project("/somewhere/oak").name(), "oak");
  EXPECT_EQ(some_project("/somewhere/oak/").name(), "oak");
  EXPECT_EQ(some_project("/somewhere/oak/.").name(), "oak");
}

}  // namespace
}  // namespace bosk
