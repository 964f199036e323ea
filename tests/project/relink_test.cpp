#include "core/project/relink.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// A project in OAK whose photos lay in PHOTOS/row_1 and row_2 and are now below ARCHIVE/2026.
class RelinkPhotos : public testing::Test {
 protected:
  RelinkPhotos() {
    project.folder = scratch / "oak";
    project.photos = {"../photos/row_1/a.jpg", "../photos/row_1/b c.jpg", "../photos/row_2/d.jpg"};
    for (const char* name : {"row_1/a.jpg", "row_1/b c.jpg", "row_2/d.jpg"}) make(moved / name);
  }
  static void make(const fs::path& file) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << file.filename();
  }
  std::string refusal(const fs::path& found) const {
    try {
      relink_photos(project, found);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  ScratchFolder scratch;
  fs::path moved = scratch / "archive" / "2026";
  Project project;
};

TEST_F(RelinkPhotos, InfersTheFolderFromOneFoundPhoto) {
  const Relinking relinking = relink_photos(project, moved / "row_1" / "a.jpg");
  EXPECT_EQ(relinking.found, 3u);
  EXPECT_TRUE(relinking.still_missing.empty());
  EXPECT_EQ(relinking.edit.before, project.photos);
  const std::vector<fs::path> expected = {"../archive/2026/row_1/a.jpg",
                                          "../archive/2026/row_1/b c.jpg",
                                          "../archive/2026/row_2/d.jpg"};
  EXPECT_EQ(relinking.edit.after, expected);
  apply(relinking.edit, project);
  EXPECT_TRUE(missing_photos(project).empty());
}

TEST_F(RelinkPhotos, TakesTheFolderOrOneAboveIt) {
  EXPECT_EQ(relink_photos(project, moved).found, 3u);
  const Relinking part = relink_photos(project, moved / "row_1");
  EXPECT_EQ(part.found, 2u);
  EXPECT_EQ(part.still_missing, (std::vector<fs::path>{"../photos/row_2/d.jpg"}));
  EXPECT_EQ(part.edit.after[2], project.photos[2]);
}

TEST_F(RelinkPhotos, FindsThemInAFlatFolder) {
  for (const char* name : {"a.jpg", "b c.jpg", "d.jpg"}) make(scratch / "flat" / name);
  EXPECT_EQ(relink_photos(project, scratch / "flat" / "d.jpg").found, 3u);
}

TEST_F(RelinkPhotos, LeavesWhatIsNotMissing) {
  make(scratch / "photos" / "row_1" / "a.jpg");
  const Relinking relinking = relink_photos(project, moved);
  EXPECT_EQ(relinking.found, 2u);
  EXPECT_EQ(relinking.edit.after[0], project.photos[0]);
}

TEST_F(RelinkPhotos, SaysWhatItLookedFor) {
  make(scratch / "other" / "x.jpg");
  EXPECT_NE(refusal(scratch / "other" / "x.jpg").find("a.jpg"), std::string::npos);
  EXPECT_NE(refusal(scratch / "other").find("a.jpg"), std::string::npos);
  project.photos.clear();
  EXPECT_NE(refusal(moved).find("no photo is missing"), std::string::npos);
}

}  // namespace
}  // namespace bosk
