// `bosk matte`: what it says of its mattes, and the page to judge them by.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/image/image_io.h"
#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class MatteCommand : public testing::Test {
 protected:
  void SetUp() override { make_tiny_capture(folder / "capture"); }
  // As large as the photos of the tiny capture.
  void spoil(const std::string& name) const {
    const auto file = folder / "capture" / "mattes" / (name + ".png");
    const Image<glm::u8vec4> full(72, 96, glm::u8vec4(90, 120, 60, 255));
    write_png(file, full);
  }
  ProgramEnd matte(std::vector<std::string> more) const {
    run_bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json", "--mattes",
              "capture/mattes", "--quiet"},
             folder.path());
    more.insert(more.begin(), {"matte", "p", "--quiet"});
    return run_bosk(more, folder.path());
  }

  ScratchFolder folder;
};

TEST_F(MatteCommand, TellsHowSureItIsOfEachPhoto) {
  const ProgramEnd end = matte({"--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const json told = json::parse(end.out);
  const auto photos =
      std::distance(std::filesystem::directory_iterator(folder / "capture" / "photos"), {});
  ASSERT_EQ(std::ptrdiff_t(told.at("photos").size()), photos);
  for (const json& photo : told.at("photos")) {
    EXPECT_GE(photo.at("confidence"), 0.0) << photo;
    EXPECT_LE(photo.at("confidence"), 1.0) << photo;
  }
  EXPECT_EQ(told.at("finished_before"), false);
  const json again = json::parse(matte({"--json"}).out);
  EXPECT_EQ(again.at("finished_before"), true);
  EXPECT_EQ(again.at("photos"), told.at("photos"));
}

TEST_F(MatteCommand, NamesTheMatteThatIsUnlikeTheOthers) {
  spoil("003");
  const ProgramEnd end = matte({"--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const json told = json::parse(end.out).at("photos");
  const auto least = std::min_element(told.begin(), told.end(), [](const json& a, const json& b) {
    return a.at("confidence") < b.at("confidence");
  });
  EXPECT_EQ(least->at("photo"), "003");
  EXPECT_EQ(least->at("look_first"), true);
}

TEST_F(MatteCommand, DrawsASheetOfAllPhotosThoseInDoubtFirst) {
  spoil("003");
  ASSERT_EQ(matte({"--sheet", "sheet.html"}).status, 0);
  const std::string page = content_of(folder / "sheet.html");
  EXPECT_THAT(page, HasSubstr("003: on magenta"));
  EXPECT_LT(page.find("<h3>003"), page.find("<h3>000"));
  std::size_t pictures = 0;
  for (auto at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1)) {
    ++pictures;
  }
  const auto photos =
      std::distance(std::filesystem::directory_iterator(folder / "capture" / "photos"), {});
  EXPECT_EQ(pictures, 4 * std::size_t(photos));
}

TEST_F(MatteCommand, SaysBeforeItBeginsWhereTheSheetCannotGo) {
  const ProgramEnd end = matte({"--sheet", "nowhere/sheet.html"});
  EXPECT_EQ(end.status, 3);
  EXPECT_THAT(end.err, HasSubstr("nowhere/sheet.html"));
  EXPECT_EQ(json::parse(matte({"--json"}).out).at("finished_before"), false);
}

}  // namespace
}  // namespace bosk
