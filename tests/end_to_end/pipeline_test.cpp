// From photographs to pictures, as a user would go.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::HasSubstr;

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

class Pipeline : public testing::Test {
 protected:
  void SetUp() override { make_tiny_capture(folder / "capture"); }

  ProgramEnd bosk(const std::vector<std::string>& arguments) const {
    return run_bosk(arguments, folder.path());
  }
  ProgramEnd make_project(const std::string& name, const std::string& mattes) const {
    return bosk(joined({"new", name, "capture/photos", "--cameras", "capture/transforms.json",
                        "--" + mattes, "capture/" + mattes, "--quiet"},
                       quick_options()));
  }

  ScratchFolder folder;
};

TEST_F(Pipeline, PhotosBecomeAPackageAndPicturesOfNewViews) {
  ASSERT_EQ(make_project("p", "mattes").status, 0);
  const ProgramEnd run = bosk({"run", "p", "-o", "t.bosk"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("Radiance"));
  const ProgramEnd drawn =
      bosk({"render", "t.bosk", "--cameras", "capture/transforms_heldout.json", "-o", "pictures"});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_TRUE(fs::exists(folder / "pictures" / "000.png"));
  EXPECT_TRUE(fs::exists(folder / "pictures" / "001.png"));
  const Json info = Json::parse(bosk({"info", "t.bosk", "--json"}).out);
  EXPECT_EQ(info.at("photos"), 6);
  EXPECT_EQ(info.at("name"), "p");
  std::size_t bytes = 0;
  for (const auto& level : info.at("levels")) {
    for (const auto& part : level.at("bytes")) bytes += part.get<std::size_t>();
  }
  EXPECT_GT(bytes, 0u);
  EXPECT_LT(bytes, info.at("bytes").get<std::size_t>());
}

// Environment variable of this process and those that it starts, for a while.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

TEST_F(Pipeline, PicturesAreDrawnThroughOpenGlOrAMessageSaysWhatToInstall) {
  ASSERT_EQ(make_project("p", "mattes").status, 0);
  ASSERT_EQ(bosk({"run", "p", "-o", "t.bosk", "--quiet"}).status, 0);
  const std::vector<std::string> render = {
      "render", "--gl", "t.bosk", "--cameras", "capture/transforms_heldout.json", "-o", "pictures"};
  {
    const Variable no_driver("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere");
    const ProgramEnd refused = bosk(render);
    EXPECT_EQ(refused.status, 3);
    EXPECT_THAT(refused.err, HasSubstr("libgl1-mesa-dri"));
    EXPECT_THAT(refused.err, HasSubstr("without --gl"));
    EXPECT_FALSE(fs::exists(folder / "pictures"));
  }
  const ProgramEnd drawn = bosk(render);
  if (drawn.status == 3) GTEST_SKIP() << drawn.err;
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_TRUE(fs::exists(folder / "pictures" / "000.png"));
  EXPECT_TRUE(fs::exists(folder / "pictures" / "001.png"));
}

TEST_F(Pipeline, StrokesOnOnePhotoAreEnough) {
  ASSERT_EQ(make_project("p", "scribbles").status, 0);
  const ProgramEnd run = bosk({"run", "p", "-o", "t.bosk", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.err;
}

TEST_F(Pipeline, ANewViewLooksLikeTheTreeItShows) {
  ASSERT_EQ(make_project("p", "mattes").status, 0);
  const ProgramEnd end =
      bosk({"evaluate", "p", "--cameras", "capture/transforms_heldout.json", "--truth",
            "capture/heldout", "--report", "report", "--json", "--quiet"});
  ASSERT_EQ(end.status, 0) << end.err;
  const Json figures = Json::parse(end.out);
  // A white frame would get about 12 dB here, a tree in the wrong place less than 15
  EXPECT_GT(figures.at("mean").at("psnr"), 17.0);
  for (const std::string name :
       {"contact-sheet.png", "figures.txt", "figures.json", "report.html"}) {
    EXPECT_TRUE(fs::exists(folder / "report" / name)) << name;
  }
  const std::string page = content_of(folder / "report" / "report.html");
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
}

TEST_F(Pipeline, HeldOutPhotosAreScoredInAProjectOfTheRest) {
  ASSERT_EQ(make_project("p", "mattes").status, 0);
  const ProgramEnd end = bosk({"evaluate", "p", "--hold-out", "3", "--json", "--quiet"});
  ASSERT_EQ(end.status, 0) << end.err;
  const Json views = Json::parse(end.out).at("views");
  EXPECT_EQ(views.size(), 2u);
  EXPECT_TRUE(views.contains("002"));
  EXPECT_TRUE(views.contains("005"));
}

TEST_F(Pipeline, QualityBelowWhatWasAskedForIsStatus4WithTheResultsWritten) {
  ASSERT_EQ(make_project("p", "mattes").status, 0);
  const ProgramEnd end = bosk(
      {"evaluate", "p", "--hold-out", "3", "--min-psnr", "90", "--report", "report", "--quiet"});
  EXPECT_EQ(end.status, 4) << end.err;
  EXPECT_TRUE(fs::exists(folder / "report" / "figures.json"));
}

TEST_F(Pipeline, AFinishedStageAskedForAgainRewritesNothing) {
  ASSERT_EQ(make_project("p", "mattes").status, 0);
  ASSERT_EQ(bosk({"run", "p", "-o", "t.bosk", "--quiet"}).status, 0);
  std::map<fs::path, fs::file_time_type> before;
  const auto files = [&] {
    std::map<fs::path, fs::file_time_type> times;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "p")) {
      if (entry.path().filename() != ".lock") times[entry.path()] = entry.last_write_time();
    }
    times[folder / "t.bosk"] = fs::last_write_time(folder / "t.bosk");
    return times;
  };
  before = files();
  for (const std::string stage : {"matte", "opacity", "radiance", "texture", "compress"}) {
    const ProgramEnd end = bosk({stage, "p"});
    EXPECT_EQ(end.status, 0);
    EXPECT_THAT(end.out, HasSubstr("was finished before"));
  }
  EXPECT_EQ(bosk({"run", "p", "-o", "t.bosk"}).status, 0);
  EXPECT_EQ(files(), before);
}

TEST_F(Pipeline, TheSamePackageComesFromOneThreadAndFromSeveral) {
  ASSERT_EQ(make_project("one", "mattes").status, 0);
  ASSERT_EQ(make_project("several", "mattes").status, 0);
  ASSERT_EQ(
      bosk({"run", "one", "-o", "1.bosk", "--threads", "1", "--pack.name=t", "--quiet"}).status, 0);
  ASSERT_EQ(
      bosk({"run", "several", "-o", "2.bosk", "--threads", "3", "--pack.name=t", "--quiet"}).status,
      0);
  EXPECT_EQ(content_of(folder / "1.bosk"), content_of(folder / "2.bosk"));
  EXPECT_FALSE(content_of(folder / "1.bosk").empty());
}

TEST_F(Pipeline, AMovedProjectNeedsNoWorkAgain) {
  fs::create_directory(folder / "here");
  fs::rename(folder / "capture", folder / "here" / "capture");
  ASSERT_EQ(run_bosk(joined({"new", "p", "capture/photos", "--cameras", "capture/transforms.json",
                             "--mattes", "capture/mattes", "--quiet"},
                            quick_options()),
                     folder / "here")
                .status,
            0);
  ASSERT_EQ(run_bosk({"opacity", "p", "--quiet"}, folder / "here").status, 0);
  fs::rename(folder / "here", folder / "there");
  const ProgramEnd again = run_bosk({"opacity", "p"}, folder / "there");
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.out, HasSubstr("was finished before"));
}

}  // namespace
}  // namespace bosk
