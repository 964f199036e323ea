#include "core/photo/camera_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <limits>

#include "core/base/error.h"
#include "tests/photo/random_cameras.h"
#include "tests/photo/refusal.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using glm::dvec2;
using glm::dvec3;
using namespace testing_cameras;
using ::testing::HasSubstr;

std::vector<LensModel> models_of(const std::string& format) {
  if (format == "cameramodel") return {LensModel::pinhole, LensModel::opencv};
  return {LensModel::pinhole, LensModel::opencv, LensModel::opencv_fisheye};
}

double largest_difference_px(const Camera& a, const Camera& b, Random& random) {
  double largest = 0.0;
  for (int i = 0; i < 100; ++i) {
    const dvec3 point = inverse(a.camera_from_world) * random_point_in_camera(random);
    const auto in_a = project(a, point), in_b = project(b, point);
    EXPECT_TRUE(in_a && in_b);
    if (in_a && in_b) largest = std::max(largest, glm::length(*in_a - *in_b));
  }
  return largest;
}

void expect_same_cameras(std::vector<Camera> expected, std::vector<Camera> read) {
  const auto by_name = [](const Camera& a, const Camera& b) { return a.name < b.name; };
  std::sort(expected.begin(), expected.end(), by_name);
  std::sort(read.begin(), read.end(), by_name);
  ASSERT_EQ(read.size(), expected.size());
  Random random(2);
  double largest = 0.0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, expected[i].name);
    EXPECT_EQ(read[i].lens.width_px, expected[i].lens.width_px);
    EXPECT_EQ(read[i].lens.height_px, expected[i].lens.height_px);
    largest = std::max(largest, largest_difference_px(expected[i], read[i], random));
  }
  EXPECT_LE(largest, 1e-6);
  ::testing::Test::RecordProperty("largest_difference_px", std::to_string(largest * 1e12) + "e-12");
}

class EveryFormat : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, ::testing::ValuesIn(camera_format_names()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(EveryFormat, ReturnsAThousandCameras) {
  Random random(1);
  const auto cameras = random_cameras(random, 1000, models_of(GetParam()));
  const TemporaryFolder folder;
  write_cameras(cameras, GetParam(), folder.path());
  expect_same_cameras(cameras, read_cameras(folder.path()));
}

TEST_P(EveryFormat, ReturnsCamerasThatShareALens) {
  Random random(3);
  auto cameras = random_cameras(random, 5, {LensModel::opencv});
  for (Camera& camera : cameras) camera.lens = cameras[0].lens;
  const TemporaryFolder folder;
  write_cameras(cameras, GetParam(), folder.path() / "made" / "for it");
  expect_same_cameras(cameras, read_cameras(folder.path() / "made" / "for it"));
}

TEST_P(EveryFormat, ASecondRoundTripChangesNoLens) {
  Random random(4);
  const TemporaryFolder a, b;
  const auto cameras = random_cameras(random, 3, {LensModel::opencv});
  write_cameras(cameras, GetParam(), a.path());
  write_cameras(read_cameras(a.path()), GetParam(), b.path());
  const auto cameras_in_b = read_cameras(b.path());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(cameras_in_b[i].lens, read_cameras(a.path())[i].lens);
}

TEST_P(EveryFormat, RefusesToWriteWhatItWouldNotRead) {
  Random random(5);
  const TemporaryFolder folder;
  const auto good = random_cameras(random, 2, {LensModel::opencv});
  const auto refusal = [&](auto change) {
    auto cameras = good;
    change(cameras[1]);
    return refusal_of([&] { write_cameras(cameras, GetParam(), folder.path() / "out"); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal([](Camera& c) { c.name = "view.0"; }), HasSubstr("two images are named"));
  EXPECT_THAT(refusal([](Camera& c) { c.name = "../up"; }), HasSubstr("up"));
  EXPECT_THAT(refusal([](Camera& c) { c.name = ".."; }), HasSubstr("name"));
  EXPECT_THAT(refusal([](Camera& c) { c.name = "a\nb"; }), HasSubstr("a?b"));
  EXPECT_THAT(refusal([](Camera& c) { c.lens.focal_px.x = -1.0; }), HasSubstr("focal length"));
  EXPECT_THAT(refusal([](Camera& c) { c.lens.width_px = 0; }), HasSubstr("image size"));
  EXPECT_THAT(refusal([&](Camera& c) { c.lens.distortion[1] = nan; }), HasSubstr("distortion"));
  EXPECT_THAT(refusal([&](Camera& c) { c.camera_from_world.translation.x = nan; }),
              HasSubstr("pose"));
  EXPECT_THAT(refusal([](Camera& c) { c.camera_from_world.rotation *= 1.1; }), HasSubstr("pose"));
  EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

TEST_P(EveryFormat, RefusesToWriteNothing) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal_of([&] { write_cameras({}, GetParam(), folder.path()); }),
              HasSubstr("no camera"));
}

TEST(WriteCameras, ListsTheKnownFormatsWhenAskedForAnother) {
  Random random(6);
  const auto cameras = random_cameras(random, 1, {LensModel::pinhole});
  EXPECT_THAT(refusal_of([&] { write_cameras(cameras, "bundler", "/nowhere"); }),
              HasSubstr("\"bundler\" is not known; choose one of colmap colmap-binary transforms "
                        "cameramodel"));
}

TEST(WriteCameras, ListsThePhotosItIsGiven) {
  Random random(7);
  auto cameras = random_cameras(random, 1, {LensModel::pinhole});
  cameras[0].name = "IMG 7";
  const std::vector<fs::path> images{"photos/IMG 7.JPG"};
  for (const std::string format : {"colmap", "colmap-binary", "transforms"}) {
    const TemporaryFolder folder;
    write_cameras(cameras, format, folder.path(), images);
    const CameraFile read = read_camera_file(folder.path());
    EXPECT_EQ(read.cameras[0].name, "IMG 7") << format;
    EXPECT_THAT(read.images[0].string(), ::testing::EndsWith("photos/IMG 7.JPG")) << format;
  }
}

TEST(ReadCameras, NamesAFileThatIsMissing) {
  EXPECT_THAT(refusal_of([] { read_cameras("/nowhere/transforms.json"); }),
              HasSubstr("/nowhere/transforms.json"));
  EXPECT_THAT(refusal_of([] { read_cameras("/nowhere/else"); }), HasSubstr("/nowhere/else"));
}

TEST(ReadCameras, SaysWhatItLookedForInAFolderWithout) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal_of([&] { read_cameras(folder.path()); }),
              HasSubstr("looked for cameras.txt with images.txt"));
}

TEST(ReadCameras, FindsTheModelInSparse0) {
  Random random(8);
  const auto cameras = random_cameras(random, 3, {LensModel::opencv});
  for (const std::string below : {"sparse/0", "sparse", "colmap/sparse/0"}) {
    const TemporaryFolder folder;
    write_cameras(cameras, "colmap-binary", folder.path() / below);
    EXPECT_EQ(read_cameras(folder.path()).size(), 3u) << below;
  }
}

TEST(ReadCameras, TellsFilesWithoutAnEndingByTheirContent) {
  Random random(9);
  const auto cameras = random_cameras(random, 1, {LensModel::opencv});
  const TemporaryFolder folder;
  write_cameras(cameras, "transforms", folder.path() / "a.json");
  write_cameras(cameras, "cameramodel", folder.path() / "b.cameramodel");
  fs::rename(folder.path() / "a.json", folder.path() / "a");
  fs::rename(folder.path() / "b.cameramodel", folder.path() / "b");
  EXPECT_EQ(read_cameras(folder.path() / "a")[0].lens.width_px, cameras[0].lens.width_px);
  EXPECT_EQ(read_cameras(folder.path() / "b")[0].lens, cameras[0].lens);
  EXPECT_THAT(refusal_of([&] { read_cameras(folder.write("c", "12 monkeys")); }),
              HasSubstr("not recognised"));
}

TEST(ReadCameras, ReadsNumbersAlikeInEveryLocale) {
  const char* const comma_locale = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  if (!comma_locale) GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed";
  Random random(10);
  const auto cameras = random_cameras(random, 2, {LensModel::opencv});
  for (const std::string& format : camera_format_names()) {
    const TemporaryFolder folder;
    write_cameras(cameras, format, folder.path());
    expect_same_cameras(cameras, read_cameras(folder.path()));
  }
  std::setlocale(LC_NUMERIC, "C");
}

}  // namespace
}  // namespace bosk
