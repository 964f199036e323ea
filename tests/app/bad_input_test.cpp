// Bad input gets one clear sentence and the right exit status, and leaves no half-made files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/image/image_io.h"
#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class BadInput : public testing::Test {
 protected:
  void SetUp() override { make_tiny_capture(folder / "capture"); }

  ProgramEnd bosk(const std::vector<std::string>& arguments) const {
    return run_bosk(arguments, folder.path());
  }
  // `bosk new p` with everything right, but for what the caller changed on disk.
  ProgramEnd make_project(const std::string& photos = "capture/photos") const {
    return bosk({"new", "p", photos, "--cameras", "capture/transforms.json", "--mattes",
                 "capture/mattes", "--quiet"});
  }
  void expect_refusal(const ProgramEnd& end, const std::string& part, int status = 3) const {
    EXPECT_EQ(end.status, status) << end.err;
    EXPECT_THAT(end.err, HasSubstr(part));
    EXPECT_THAT(end.err, HasSubstr("bosk: "));
    EXPECT_EQ(end.out, "");
  }

  ScratchFolder folder;
};

TEST_F(BadInput, AFolderWithoutPhotos) {
  fs::create_directory(folder / "empty");
  expect_refusal(make_project("empty"), "empty: holds no photos");
  EXPECT_FALSE(fs::exists(folder / "p"));
}

TEST_F(BadInput, APhotoThatIsNotThere) {
  expect_refusal(make_project("none.jpg"), "none.jpg: cannot be read");
}

TEST_F(BadInput, OnePhoto) {
  expect_refusal(make_project("capture/photos/000.jpg"), "at least 2 usable photos");
  EXPECT_FALSE(fs::exists(folder / "p"));
}

TEST_F(BadInput, CamerasThatMatchNoPhoto) {
  fs::create_directory(folder / "renamed");
  for (const std::string name : {"000", "001", "002"}) {
    fs::copy(folder / "capture" / "photos" / (name + ".jpg"),
             folder / "renamed" / ("x" + name + ".jpg"));
  }
  expect_refusal(make_project("renamed"), "no camera of that name");
}

TEST_F(BadInput, NoCameras) {
  EXPECT_EQ(bosk({"new", "p", "capture/photos"}).status, 0);
  EXPECT_THAT(bosk({"info", "p"}).out, HasSubstr("no cameras yet"));
  // Looked for in the photos themselves, which show no markers and are too small for features
  expect_refusal(bosk({"run", "p", "--quiet", "--calibrate.features=off"}),
                 "no cameras could be found");
  EXPECT_EQ(bosk({"new", "--replace", "p", "--cameras", "capture/transforms.json"}).status, 0);
}

TEST_F(BadInput, AFolderWithoutCameras) {
  expect_refusal(bosk({"new", "p", "capture/photos", "--cameras", "capture/mattes"}),
                 "capture/mattes");
}

TEST_F(BadInput, PhotosThatAreDamaged) {
  fs::create_directory(folder / "damaged");
  for (const std::string name : {"000.jpg", "001.jpg", "002.jpg"}) {
    std::ofstream(folder / "damaged" / name) << "no picture";
  }
  expect_refusal(make_project("damaged"), "000");
}

TEST_F(BadInput, OneDamagedPhotoAmongGoodOnesIsLeftOutWithAReason) {
  std::ofstream(folder / "capture" / "photos" / "002.jpg") << "no picture";
  const ProgramEnd end = make_project();
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("5 of 6 photos"));
  EXPECT_THAT(end.out, HasSubstr("002: NOT USED"));
}

TEST_F(BadInput, AMatteThatIsClearEverywhere) {
  write_png(folder / "capture" / "mattes" / "003.png",
            Image<glm::u8vec4>(72, 96, glm::u8vec4(10, 20, 30, 0)));
  ASSERT_EQ(make_project().status, 0);
  expect_refusal(bosk({"run", "p", "--quiet"}), "003.png: the matte is clear everywhere");
}

TEST_F(BadInput, AMatteOfAnotherShape) {
  write_png(folder / "capture" / "mattes" / "003.png",
            Image<glm::u8vec4>(50, 96, glm::u8vec4(10, 20, 30, 255)));
  ASSERT_EQ(make_project().status, 0);
  expect_refusal(bosk({"run", "p", "--quiet"}), "003.png");
}

// The photos of a stem before the sky: a first guess is made, and said to be one.
TEST_F(BadInput, NeitherMattesNorStrokesIsAGuessThatIsSaid) {
  ASSERT_EQ(bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json"}).status, 0);
  const ProgramEnd end = bosk({"matte", "p"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("the tree was guessed"));
}

TEST_F(BadInput, AProjectThatIsNotThere) {
  expect_refusal(bosk({"run", "nowhere"}), "nowhere: there is no such folder");
}

TEST_F(BadInput, AFolderThatIsNoProject) {
  expect_refusal(bosk({"run", "capture"}), "holds no project");
}

TEST_F(BadInput, AProjectOverAnother) {
  ASSERT_EQ(make_project().status, 0);
  expect_refusal(make_project(), "holds a project already");
}

TEST_F(BadInput, AProjectFileThatIsDamaged) {
  ASSERT_EQ(make_project().status, 0);
  std::ofstream(folder / "p" / "project.json") << "{";
  expect_refusal(bosk({"run", "p"}), "project.json: is damaged");
}

TEST_F(BadInput, APackageThatIsDamaged) {
  std::ofstream(folder / "t.bosk") << "no package";
  expect_refusal(bosk({"info", "t.bosk"}), "t.bosk");
  expect_refusal(bosk({"render", "t.bosk", "--cameras", "capture/transforms.json", "-o", "out"}),
                 "t.bosk");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(BadInput, AFolderThatCannotBeWritten) {
  fs::create_directory(folder / "closed");
  const auto end = run_on_mount("ro none closed",
                                "new closed/p capture/photos --cameras capture/transforms.json "
                                "--mattes capture/mattes --quiet",
                                folder.path());
  if (!end) GTEST_SKIP() << "no mount namespaces here";
  expect_refusal(*end, "closed/p: cannot be created");
}

TEST_F(BadInput, AFolderThatTheUserMayNotWrite) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  const auto end = bosk({"new", "closed/p", "capture/photos", "--cameras",
                         "capture/transforms.json", "--mattes", "capture/mattes", "--quiet"});
  fs::permissions(folder / "closed", fs::perms::owner_all);
  expect_refusal(end, "closed/p: cannot be created");
}

TEST_F(BadInput, AnOutputInAFolderThatIsNotThere) {
  ASSERT_EQ(make_project().status, 0);
  auto arguments = quick_options();
  arguments.insert(arguments.begin(), {"run", "p", "-o", "none/t.bosk", "--quiet"});
  expect_refusal(bosk(arguments), "none/t.bosk: cannot be written");
}

TEST_F(BadInput, AFullDiskIsStatus5AndLeavesTheProjectSound) {
  ASSERT_EQ(make_project().status, 0);
  const auto end = run_on_mount("size=128k none p/cache", "run p --quiet", folder.path());
  if (!end) GTEST_SKIP() << "no mount namespaces here";
  expect_refusal(*end, "p/cache/", 5);
  auto arguments = quick_options();
  arguments.insert(arguments.begin(), {"run", "p", "--quiet"});
  EXPECT_EQ(bosk(arguments).status, 0);
}

TEST_F(BadInput, AProjectThatAnotherProcessWorksOnIsTemporary) {
  ASSERT_EQ(make_project().status, 0);
  const fs::path lock = folder / "p" / ".lock";  // names its holder as soon as it is taken
  fs::remove(lock);
  auto arguments = quick_options();
  arguments.insert(arguments.begin(), {"run", "p", "--quiet", "--radiance.epochs=50"});
  Program first(arguments, folder.path());
  while (first.is_running() && content_of(lock).empty())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  expect_refusal(bosk({"matte", "p", "--quiet", "--matte.clusters=7"}),
                 "is working on this project", 75);
}

}  // namespace
}  // namespace bosk
