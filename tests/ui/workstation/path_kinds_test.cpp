#include "ui/workstation/path_kinds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Files are told by their names, so they need no content.
void make(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "x";
}

TEST(SortedOut, TakesAFoldersPhotosAndNothingElseInIt) {
  const ScratchFolder folder;
  for (const char* name : {"b.JPG", "a.jpg", "notes.txt", ".hidden.jpg"}) make(folder / name);
  const NamedPaths paths = sorted_out({folder.path()});
  EXPECT_THAT(paths.photos, ElementsAre(folder / "a.jpg", folder / "b.JPG"));
  EXPECT_TRUE(paths.cameras.empty());
  EXPECT_THAT(paths.left_out, IsEmpty());
}

TEST(SortedOut, FindsPhotosAndCamerasWhereColmapLeavesThem) {
  const ScratchFolder folder;
  make(folder / "images/a.jpg");
  make(folder / "sparse/0/cameras.bin");
  const NamedPaths paths = sorted_out({folder.path()});
  EXPECT_THAT(paths.photos, ElementsAre(folder / "images/a.jpg"));
  EXPECT_EQ(paths.cameras, folder.path());
}

TEST(SortedOut, KnowsCameraFilesByTheirNames) {
  const ScratchFolder folder;
  for (const char* name : {"transforms.json", "a.cameramodel"}) {
    make(folder / name);
    EXPECT_EQ(sorted_out({folder / name}).cameras, folder / name);
  }
  make(folder / "model/images.txt");
  EXPECT_EQ(sorted_out({folder / "model/images.txt"}).cameras, folder / "model");
}

TEST(SortedOut, OpensAProjectByItsFolderOrItsFile) {
  const ScratchFolder folder;
  make(folder / "oak/project.json");
  make(folder / "oak/a.jpg");
  EXPECT_EQ(sorted_out({folder / "oak"}).project, folder / "oak");
  EXPECT_EQ(sorted_out({folder / "oak/"}).project, folder / "oak");
  EXPECT_EQ(sorted_out({folder / "oak/project.json"}).project, folder / "oak");
  EXPECT_THAT(sorted_out({folder / "oak"}).photos, IsEmpty());
}

TEST(SortedOut, SaysWhyItLeavesSomethingOut) {
  const ScratchFolder folder;
  make(folder / "notes.txt");
  make(folder / "oak.bosk");
  fs::create_directory(folder / "empty");
  const NamedPaths paths =
      sorted_out({folder / "notes.txt", folder / "oak.bosk", folder / "empty", folder / "gone"});
  EXPECT_THAT(paths.left_out,
              ElementsAre(HasSubstr("notes.txt: is neither"), HasSubstr("bosk view"),
                          HasSubstr("empty: holds neither"), HasSubstr("no such file")));
}

TEST(SortedOut, TakesEachPhotoOnceAndOneCameraFile) {
  const ScratchFolder folder;
  for (const char* name : {"a.jpg", "b.json", "c.json"}) make(folder / name);
  const NamedPaths paths =
      sorted_out({folder / "a.jpg", folder / "a.jpg", folder / "b.json", folder / "c.json"});
  EXPECT_THAT(paths.photos, ElementsAre(folder / "a.jpg"));
  EXPECT_EQ(paths.cameras, folder / "b.json");
  EXPECT_THAT(paths.left_out, ElementsAre(HasSubstr("c.json: one at a time")));
}

TEST(SortedOut, LeavesOutAnEmptyPath) {
  EXPECT_THAT(sorted_out({""}).left_out, ElementsAre(HasSubstr("is no path")));
}

TEST(MattesFor, AreFilesThatAreCalledLikeThePhotosAndAreNone) {
  const ScratchFolder folder;
  for (const char* name : {"photos/a.jpg", "photos/b.jpg", "mattes/b.png", "mattes/c.png"}) {
    make(folder / name);
  }
  const std::vector<fs::path> photos = {folder / "photos/a.jpg", folder / "photos/b.jpg"};
  EXPECT_THAT(mattes_for(photos, folder / "mattes"), ElementsAre(folder / "mattes/b.png"));
  EXPECT_THAT(mattes_for(photos, folder / "photos"), IsEmpty());
  EXPECT_THAT(mattes_for(photos, folder / "nowhere"), IsEmpty());
  make(folder / "mattes/project.json");
  EXPECT_THAT(mattes_for(photos, folder / "mattes"), IsEmpty());
}

TEST(PathOfText, IsEmptyForBlanks) { EXPECT_EQ(path_of_text("  \t"), ""); }

TEST(PathOfText, TakesAwayWhatPastingAdds) {
  EXPECT_EQ(path_of_text("  '/a/my tree'\n"), "/a/my tree");
  EXPECT_EQ(path_of_text("\"/a/b.jpg\""), "/a/b.jpg");
  EXPECT_EQ(path_of_text("file:///a/my%20tree"), "/a/my tree");
  EXPECT_EQ(path_of_text("/a/50%25"), "/a/50%25");
  EXPECT_EQ(path_of_text(""), "");
}

TEST(PathOfText, KnowsThePersonsOwnFolder) {
  const char* home = std::getenv("HOME");
  if (!home) GTEST_SKIP() << "there is none";
  EXPECT_EQ(path_of_text("~/oak"), fs::path(home) / "oak");
}

}  // namespace
}  // namespace bosk
