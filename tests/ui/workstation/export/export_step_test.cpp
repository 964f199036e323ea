#include "ui/workstation/export/export_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/package/reader.h"
#include "core/photo/camera_files.h"
#include "core/project/export.h"
#include "core/render/gl/headless_context.h"
#include "tests/base/scratch_folder.h"
#include "tests/ui/workstation/finished_project.h"
#include "tests/ui/workstation/hand.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ExportStep : public testing::Test {
 protected:
  ExportStep() : project(finished_project(scratch.path())) {
    open_project(hand.workspace(), project.folder);
    hand.settle();
    hand.click("step/export");
    hand.settle();
  }

  void write(const std::string& item) {
    ASSERT_TRUE(hand.is_enabled("export/" + item + "/write"));
    hand.click("export/" + item + "/write");
    ASSERT_TRUE(hand.settle());
    EXPECT_TRUE(hand.sees("export/" + item + "/told"));
  }
  const std::string& told(const std::string& item) {
    return hand.workspace().export_tree.told.at(item);
  }
  std::size_t bytes_in(const fs::path& folder) {
    std::size_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(folder)) bytes += entry.file_size();
    return bytes;
  }

  const ScratchFolder scratch;
  const Project project;
  Hand hand;
};

TEST_F(ExportStep, ThePackageIsWhatARunOfTheStagesMakes) {
  const fs::path path = usual_package_path(project);
  ASSERT_FALSE(fs::exists(path));
  write("package");
  Progress quiet;
  const bosk::Run run = run_stages(project, gather_capture(project), {"pack"}, quiet);
  EXPECT_EQ(read_file(path, 1u << 30), *run.results.package);
  EXPECT_THAT(told("package"), HasSubstr(path.string()));
}

TEST_F(ExportStep, SaysTheExactSizeOfThePackageAndWhatItReplaces) {
  EXPECT_FALSE(hand.sees("export/package/replaces"));
  const ExportItem item = package_item(hand.workspace());
  EXPECT_THAT(item.size, HasSubstr(std::to_string(hand.workspace().results.package->size())));
  write("package");
  EXPECT_TRUE(hand.sees("export/package/replaces"));
}

TEST_F(ExportStep, APackageThatIsThereAlreadyKeepsItsTime) {
  write("package");
  const fs::path path = usual_package_path(project);
  const auto past = fs::last_write_time(path) - std::chrono::hours(1);
  fs::last_write_time(path, past);
  write("package");
  EXPECT_EQ(fs::last_write_time(path), past);
  EXPECT_THAT(told("package"), HasSubstr("already"));
}

TEST_F(ExportStep, GoesWhereTheTypedPathSays) {
  hand.click("export/package/path");
  hand.workspace().export_tree.paths["package"].clear();
  hand.frame();
  hand.click("export/format");  // the keyboard leaves the field
  hand.workspace().export_tree.paths["package"] = (scratch.path() / "elsewhere.bosk").string();
  hand.click_at({1380, 600});
  hand.frame(2);
  write("package");
  EXPECT_TRUE(fs::exists(scratch.path() / "elsewhere.bosk"));
}

TEST_F(ExportStep, AFailureNamesTheFileAndLeavesNothing) {
  write_file_atomically(scratch.path() / "file", std::string_view("no folder"));
  const std::string path = (scratch.path() / "file" / "tree.bosk").string();
  hand.workspace().export_tree.paths["package"] = path;
  hand.frame();
  hand.click("export/package/write");
  ASSERT_TRUE(hand.settle());
  EXPECT_FALSE(hand.sees("export/package/told"));
  ASSERT_FALSE(hand.workspace().jobs.records().empty());
  EXPECT_THAT(hand.workspace().jobs.records().back().message, HasSubstr(path));
}

TEST_F(ExportStep, LicenceAndCreditAreEditedAndGoIntoThePackage) {
  hand.click("options/pack.licence");
  hand.type("CC0-1.0");
  hand.click("options/pack.credit");
  hand.type("Ann");
  hand.click_at({1380, 620});
  hand.frame();
  EXPECT_EQ(hand.workspace().project().recipe.pack.licence, "CC0-1.0");
  EXPECT_EQ(hand.workspace().project().recipe.pack.credit, "Ann");
  EXPECT_EQ(hand.workspace().session->undo_title(), "pack.credit nothing to Ann");
  EXPECT_FALSE(hand.is_enabled("export/package/write")) << "the package doesn't say so yet";
  hand.click("preview/make");
  ASSERT_TRUE(hand.settle());
  write("package");
  const TreeModel tree = load_tree(usual_package_path(project));
  EXPECT_EQ(tree.metadata.licence, "CC0-1.0");
  EXPECT_EQ(tree.metadata.credit, "Ann");
}

// Estimates are there to tell a megabyte from ten; a factor of three is what they keep to on trees
// from these to one of 0.7 megapixel photos.
TEST_F(ExportStep, MattesLieInThePhotosPixelsAndTheirSizeWasEstimatedWithinAFactorOfThree) {
  const std::size_t estimate = estimated_rgba_bytes(*hand.workspace().results.views,
                                                    coverage_of(*hand.workspace().results.mattes));
  write("mattes");
  const fs::path folder = project.folder / "mattes";
  for (const char* name : {"000.png", "007.png"}) EXPECT_TRUE(fs::exists(folder / name)) << name;
  const double ratio = double(estimate) / double(bytes_in(folder));
  EXPECT_GT(ratio, 1.0 / 3.0);
  EXPECT_LT(ratio, 3.0);
}

TEST_F(ExportStep, PicturesAreOfEveryPhotosCamera) {
  write("pictures");
  for (const char* name : {"000.png", "007.png"}) {
    EXPECT_TRUE(fs::exists(project.folder / "pictures" / name)) << name;
  }
  EXPECT_TRUE(hand.sees("export/pictures/replaces"));
}

TEST_F(ExportStep, TheTurntableIsDrawnBesideTheWindow) {
  try {
    const HeadlessContext context;
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  hand.workspace().export_tree.turntable_frames = 2;
  hand.workspace().export_tree.turntable_px = {64, 48};
  hand.frame();
  write("turntable");
  EXPECT_TRUE(fs::exists(project.folder / "turntable" / "frame-0001.png"));
  EXPECT_THAT(told("turntable"), HasSubstr("2 pictures"));
}

TEST_F(ExportStep, CamerasReadBackAsTheyWere) {
  write("cameras");
  const std::vector<Camera> cameras = read_cameras(project.folder / "cameras-colmap");
  const std::vector<Camera> before = read_cameras(project.absolute(project.cameras));
  ASSERT_EQ(cameras.size(), before.size());
  // The formats agree to 1e-6 px; focal lengths here are below 100 px
  EXPECT_NEAR(cameras.front().lens.focal_px.x, before.front().lens.focal_px.x, 1e-6);
}

TEST_F(ExportStep, TheReportScoresFirstWhereThereAreNoScores) {
  hand.workspace().preview.held_out.every = 4;
  hand.frame();
  write("report");
  EXPECT_TRUE(fs::exists(project.folder / "report" / "report.html"));
  EXPECT_TRUE(fs::exists(project.folder / "report" / "figures.json"));
}

}  // namespace
}  // namespace bosk
