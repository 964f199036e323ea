// `bosk view` without a window: pictures, turntables, and what it says to bad input.

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/image/image_io.h"
#include "core/package/writer.h"
#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"
#include "tests/package/sample_tree.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Image<glm::u8vec3> read_picture(const fs::path& path) {
  auto input = OIIO::ImageInput::open(path.string());
  if (!input || input->spec().nchannels != 3) return {};
  Image<glm::u8vec3> picture(input->spec().width, input->spec().height);
  input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.data());
  return picture;
}

// Pixels that differ by more than noise.
int differing(const Image<glm::u8vec3>& a, const Image<glm::u8vec3>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::ivec3 apart = glm::abs(glm::ivec3(a.pixels()[i]) - glm::ivec3(b.pixels()[i]));
    count += std::max({apart.r, apart.g, apart.b}) > 8 ? 1 : 0;
  }
  return count;
}

class View : public testing::Test {
 protected:
  void SetUp() override {
    Progress quiet;
    TreeModel tree = sample_tree({.levels = {2, 3}});
    tree.metadata.height_m = 3.25;
    write_package(folder / "tree.bosk", tree, quiet);
    tree = sample_tree({.levels = {2, 3}, .seed = 9});
    tree.metadata.height_m = 3.25;
    write_package(folder / "other.bosk", tree, quiet);
  }

  ProgramEnd view(std::vector<std::string> arguments, const std::string& package = "tree.bosk") {
    arguments.insert(arguments.begin(), {"view", package, "--quiet", "--size", "96x64"});
    return run_bosk(arguments, folder.path());
  }
  // A screenshot with its figures; a null value, and the test skipped, where there is no OpenGL.
  nlohmann::json shot(const std::string& name, std::vector<std::string> arguments = {},
                      const std::string& package = "tree.bosk") {
    arguments.insert(arguments.end(), {"--screenshot", name, "--json"});
    const ProgramEnd end = view(arguments, package);
    if (end.status != 0) {
      ADD_FAILURE() << end.err;
      return {};
    }
    return nlohmann::json::parse(end.out);
  }
  bool has_opengl() {
    const ProgramEnd end = view({"--screenshot", "probe.png"});
    if (end.status == 3 && end.err.find("OpenGL cannot be used") != std::string::npos) {
      reason = end.err;
      return false;
    }
    return true;
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  }
  void expect_refusal(const ProgramEnd& end, const std::string& part, int status = 3) {
    EXPECT_EQ(end.status, status) << end.err;
    EXPECT_THAT(end.err, HasSubstr(part));
    EXPECT_EQ(end.out, "");
    EXPECT_FALSE(fs::exists(folder / "out.png"));
  }
  Image<glm::u8vec3> picture(const std::string& name) { return read_picture(folder / name); }

  ScratchFolder folder;
  std::string reason;
};

#define SKIP_WITHOUT_OPENGL() \
  if (!has_opengl()) GTEST_SKIP() << reason

TEST_F(View, ScreenshotShowsATreeInTheSizeAskedFor) {
  SKIP_WITHOUT_OPENGL();
  const auto result = shot("a.png");
  ASSERT_EQ(picture("a.png").width(), 96);
  ASSERT_EQ(picture("a.png").height(), 64);
  EXPECT_EQ(result.at("pictures"), nlohmann::json({"a.png"}));
  const auto& figures = result.at("figures");
  EXPECT_GT(figures.at("billboards"), 0);
  EXPECT_EQ(figures.at("trees_drawn"), 1);
  EXPECT_GT(figures.at("texture_bytes"), 0);
  EXPECT_GT(figures.at("overdraw"), 0.0);
  // The tree covers much of the picture: looking away changes it
  shot("away.png", {"--eye", "0,-9,1.7", "--at", "0,-20,1.7"});
  EXPECT_GT(differing(picture("a.png"), picture("away.png")), 96 * 64 / 20);
}

TEST_F(View, TheSameCallGivesTheSamePicture) {
  SKIP_WITHOUT_OPENGL();
  for (const std::string name : {"a.png", "b.png"}) {
    shot(name, {"--trees", "20", "--terrain_m", "2", "--seed", "4", "--eye", "-12,-12,6"});
  }
  EXPECT_EQ(content_of(folder / "a.png"), content_of(folder / "b.png"));
}

TEST_F(View, OptionsChangeThePicture) {
  SKIP_WITHOUT_OPENGL();
  const std::vector<std::string> forest = {"--trees", "12"};
  shot("plain.png", forest);
  const std::vector<std::vector<std::string>> changes = {
      {"--colours", "levels"}, {"--colours", "cells"}, {"--seed", "2"},
      {"--spacing", "3"},      {"--terrain_m", "20"},  {"--view_angle_deg", "30"},
      {"--eye", "-9,2,1"},     {"--area_m", "40"},     {"--cameras", "true"}};
  for (std::vector<std::string> arguments : changes) {
    const std::string what = arguments[0] + " " + arguments[1];
    arguments.insert(arguments.end(), forest.begin(), forest.end());
    shot("changed.png", arguments);
    EXPECT_GT(differing(picture("plain.png"), picture("changed.png")), 20) << what;
  }
}

TEST_F(View, ABudgetBoundsTheBillboards) {
  SKIP_WITHOUT_OPENGL();
  const auto all = shot("all.png", {"--trees", "50", "--budget", "0"});
  const auto some = shot("some.png", {"--trees", "50", "--budget", "2000"});
  EXPECT_GT(all.at("figures").at("billboards"), 5000);
  EXPECT_LE(some.at("figures").at("billboards"), 2600);  // about: a quarter more is let pass
}

TEST_F(View, TreesStandWhereATablePutsThem) {
  SKIP_WITHOUT_OPENGL();
  write("places.csv", "x,y,tree,scale\n-3,0,other,1\n3,0,1,0.5\n");
  const ProgramEnd end = run_bosk({"view", "tree.bosk", "other.bosk", "--positions", "places.csv",
                                   "--screenshot", "a.png", "--size", "96x64", "--json", "--quiet"},
                                  folder.path());
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(nlohmann::json::parse(end.out).at("figures").at("trees"), 2);
}

TEST_F(View, ADensityMapThinsTheForest) {
  SKIP_WITHOUT_OPENGL();
  Image<std::uint8_t> map(16, 16, 255);
  for (int y = 0; y < 16; ++y) {
    for (int x = 8; x < 16; ++x) map(x, y) = 0;
  }
  write_png(folder / "map.png", map);
  const auto result = shot("west.png", {"--trees", "30", "--density", "map.png"});
  EXPECT_EQ(result.at("figures").at("trees"), 30);
  EXPECT_LT(result.at("at")[0], 0.0);  // all in the west
}

TEST_F(View, ATurntableGoesRoundAndBecomesAVideoWhereFfmpegIs) {
  SKIP_WITHOUT_OPENGL();
  const ProgramEnd end = view({"--turntable", "round/deep", "--frames", "4", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto result = nlohmann::json::parse(end.out);
  ASSERT_EQ(result.at("pictures").size(), 4u);
  const auto first = picture("round/deep/frame-0000.png");
  for (int i = 1; i < 4; ++i) {
    const auto next = picture("round/deep/frame-000" + std::to_string(i) + ".png");
    ASSERT_EQ(next.width(), 96);
    EXPECT_GT(differing(first, next), 20);
  }
  if (std::system("ffmpeg -version >/dev/null 2>&1") == 0) {
    EXPECT_GT(fs::file_size(folder / "round/deep/turntable.mp4"), 100u);
    EXPECT_EQ(result.at("video"), "round/deep/turntable.mp4");
  } else {
    EXPECT_THAT(end.err, HasSubstr("no video: ffmpeg is not in PATH"));
  }
}

TEST_F(View, ATurntableWithoutFfmpegKeepsItsPicturesAndSaysSo) {
  SKIP_WITHOUT_OPENGL();
  fs::create_directory(folder / "nothing");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder / "nothing").c_str(), 1);
  const ProgramEnd end = view({"--turntable", "round", "--frames", "2"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, HasSubstr("no video: ffmpeg is not in PATH"));
  EXPECT_FALSE(fs::exists(folder / "round/turntable.mp4"));
  EXPECT_TRUE(fs::exists(folder / "round/frame-0001.png"));
}

TEST_F(View, AFailingFfmpegIsTold) {
  SKIP_WITHOUT_OPENGL();
  fs::create_directory(folder / "bin");
  write("bin/ffmpeg", "#!/bin/sh\necho broken\nexit 7\n");
  fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", ((folder / "bin").string() + ":" + path).c_str(), 1);
  const ProgramEnd end = view({"--turntable", "round", "--frames", "1"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, HasSubstr("ffmpeg ended with status 7"));
  EXPECT_THAT(content_of(folder / "round/ffmpeg.log"), HasSubstr("broken"));
}

TEST_F(View, OutputsThatCannotBeWrittenAreNamed) {
  SKIP_WITHOUT_OPENGL();
  write("file", "");
  expect_refusal(view({"--screenshot", "nowhere/a.png"}), "nowhere/a.png");
  expect_refusal(view({"--turntable", "file"}), "file: cannot be created");
  expect_refusal(view({"--turntable", "file/deeper"}), "file/deeper: cannot be created");
}

TEST_F(View, PackagesThatAreNoUseAreNamed) {
  expect_refusal(view({"--screenshot", "out.png"}, "none.bosk"), "none.bosk");
  write("text.bosk", "no package");
  expect_refusal(view({"--screenshot", "out.png"}, "text.bosk"), "text.bosk");
  std::string bytes = content_of(folder / "tree.bosk");
  bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 0x40);
  write("damaged.bosk", bytes);
  expect_refusal(view({"--screenshot", "out.png"}, "damaged.bosk"), "damaged.bosk");
}

TEST_F(View, PlacesAndMapsThatAreNoUseAreNamed) {
  write("empty.csv", "x,y\n");
  expect_refusal(view({"--screenshot", "out.png", "--positions", "empty.csv"}),
                 "empty.csv: holds no tree");
  write("broken.csv", "x,y\n1,2\n3,up\n");
  expect_refusal(view({"--screenshot", "out.png", "--positions", "broken.csv"}),
                 "broken.csv, line 3: y is \"up\"");
  expect_refusal(view({"--screenshot", "out.png", "--positions", "none.csv"}), "none.csv");
  write_png(folder / "black.png", Image<std::uint8_t>(4, 4, 0));
  expect_refusal(view({"--screenshot", "out.png", "--trees", "5", "--density", "black.png"}),
                 "the density map is black all over");
  write("map.png", "no picture");
  expect_refusal(view({"--screenshot", "out.png", "--trees", "5", "--density", "map.png"}),
                 "map.png");
  expect_refusal(view({"--screenshot", "out.png", "--trees", "5000", "--area_m", "20"}),
                 "of 5000 trees fit into the area");
}

TEST_F(View, BadUsageIsToldBeforeAnythingIsRead) {
  expect_refusal(run_bosk({"view"}, folder.path()), "TREE.bosk", 2);
  expect_refusal(view({"--trees", "-1"}), "trees", 2);
  expect_refusal(view({"--eye", "1,2"}, "none.bosk"), "--eye 1,2: give metres", 2);
  expect_refusal(view({"--at", "1,2,x"}, "none.bosk"), "--at 1,2,x", 2);
  expect_refusal(view({"--colours", "red"}), "choose one of tree, levels, cells, pruned", 2);
  expect_refusal(view({"--density", "map.png"}, "none.bosk"), "--density thins a forest", 2);
  expect_refusal(view({"--positions", "a.csv", "--trees", "3"}, "none.bosk"), "leave --trees", 2);
  for (const std::string size : {"0x4", "12", "12x", "x12", "1.5x2", "99999x2", "-4x4"}) {
    const ProgramEnd end = run_bosk({"view", "none.bosk", "--size=" + size}, folder.path());
    expect_refusal(end, "--size " + size, 2);
  }
}

TEST_F(View, HelpTeaches) {
  const ProgramEnd end = run_bosk({"view", "--help"}, folder.path());
  EXPECT_EQ(end.status, 0);
  for (const std::string part :
       {"--trees", "--density", "--positions", "--terrain_m", "--seed", "--budget", "--frame_ms",
        "--screenshot", "--turntable", "--frames", "--eye", "unless given",
        "In the window:", "walk on the ground", "bosk view oak.bosk --trees 2000"}) {
    EXPECT_THAT(end.out, HasSubstr(part));
  }
}

}  // namespace
}  // namespace bosk
