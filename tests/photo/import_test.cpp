#include "core/photo/import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/base/error.h"
#include "core/photo/resample.h"
#include "tests/base/scratch_folder.h"
#include "tests/photo/photo_writer.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

Camera camera_named(const std::string& name, int width = 40, int height = 30) {
  Camera camera;
  camera.name = name;
  camera.lens.model = LensModel::opencv;
  camera.lens.width_px = width;
  camera.lens.height_px = height;
  camera.lens.focal_px = glm::dvec2(1.1 * width);
  camera.lens.principal_px = 0.5 * (glm::dvec2(width, height) - 1.0);
  camera.lens.distortion[0] = -0.1;
  camera.camera_from_world.translation = {1.0, 2.0, 3.0};
  return camera;
}

PhotoImport import(const std::vector<fs::path>& files, const std::vector<Camera>& cameras,
                   const PhotoOptions& options = {}) {
  Progress quiet;
  return import_photos(files, cameras, options, quiet);
}

std::vector<fs::path> write_photos(const ScratchFolder& folder, int count) {
  std::vector<fs::path> files;
  for (int i = 0; i < count; ++i) {
    files.push_back(folder / ("photo" + std::to_string(i) + ".png"));
    EXPECT_TRUE(write_photo(files.back(), {.width = 40 + 4 * i, .height = 30 + 3 * i}));
  }
  return files;
}

std::vector<Camera> cameras_for(int count) {
  std::vector<Camera> cameras;
  for (int i = count - 1; i >= 0; --i) {
    cameras.push_back(camera_named("photo" + std::to_string(i), 40 + 4 * i, 30 + 3 * i));
  }
  return cameras;
}

TEST(ImportPhotos, MatchesCamerasByNameAndKeepsTheOrderOfTheFiles) {
  const ScratchFolder folder;
  const PhotoImport result = import(write_photos(folder, 3), cameras_for(3));
  ASSERT_EQ(result.photos.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const Photo& photo = result.photos[std::size_t(i)];
    EXPECT_EQ(photo.name, "photo" + std::to_string(i));
    EXPECT_EQ(photo.original_camera.lens.width_px, 40 + 4 * i);
    EXPECT_EQ(photo.original_camera.lens.model, LensModel::opencv);
    EXPECT_EQ(photo.camera.lens, undistorted(photo.original_camera.lens));
    EXPECT_EQ(photo.camera.camera_from_world.translation.z, 3.0);
    EXPECT_EQ(photo.srgb.width(), 40 + 4 * i);
    EXPECT_TRUE(result.rgba[std::size_t(i)].empty());
  }
}

TEST(ImportPhotos, ScalesDownToTheWorkingSizeAndNeverUp) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "a.png", {.width = 400, .height = 300}));
  PhotoOptions options;
  options.working_megapixels = 0.03;
  const Photo small = import({folder / "a.png"}, {camera_named("a", 400, 300)}, options).photos[0];
  EXPECT_EQ(small.camera.lens.width_px, 200);
  EXPECT_EQ(small.srgb.height(), 150);
  EXPECT_DOUBLE_EQ(small.camera.lens.focal_px.x, 220.0);
  EXPECT_EQ(small.original_camera.lens.width_px, 400);
  EXPECT_EQ(working_size(400, 300, 1.0), glm::ivec2(400, 300));
}

TEST(ImportPhotos, TakesACameraCalibratedAtAnotherSizeOfTheSameShape) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "a.png", {.width = 80, .height = 60}));
  const Photo photo = import({folder / "a.png"}, {camera_named("a", 4000, 3000)}).photos[0];
  EXPECT_DOUBLE_EQ(photo.original_camera.lens.focal_px.x, 88.0);
}

TEST(ImportPhotos, GivesEveryRejectedFileAReasonAndGoesOn) {
  const ScratchFolder folder;
  std::vector<fs::path> files = write_photos(folder, 2);
  fs::copy_file(files[0], folder / "copy.png");
  fs::create_directory(folder / "elsewhere");
  ASSERT_TRUE(write_photo(folder / "elsewhere/photo1.jpg", {.width = 44, .height = 33}));
  ASSERT_TRUE(write_photo(folder / "tiny.png", {.width = 15, .height = 200}));
  ASSERT_TRUE(write_photo(folder / "stranger.png", {.width = 20, .height = 20}));
  ASSERT_TRUE(write_photo(folder / "turned.png", {.width = 30, .height = 40}));
  for (const char* name : {"copy.png", "elsewhere/photo1.jpg", "tiny.png", "stranger.png",
                           "turned.png", "missing.png"}) {
    files.push_back(folder / name);
  }
  std::vector<Camera> cameras = cameras_for(2);
  for (const char* name : {"copy", "tiny", "turned", "missing"})
    cameras.push_back(camera_named(name));
  int warnings = 0;
  Progress progress({}, [&](const std::string&) { ++warnings; });
  const PhotoImport result = import_photos(files, cameras, {}, progress);
  EXPECT_EQ(result.photos.size(), 2u);
  EXPECT_EQ(warnings, 6);
  ASSERT_EQ(result.verdicts.size(), 8u);
  EXPECT_TRUE(result.verdicts[0].accepted && result.verdicts[1].accepted);
  EXPECT_THAT(result.verdicts[0].reason, StartsWith("PNG, 40 x 30, undistorted"));
  EXPECT_THAT(result.verdicts[2].reason, HasSubstr("copy of"));
  EXPECT_THAT(result.verdicts[3].reason, HasSubstr("same name"));
  EXPECT_THAT(result.verdicts[4].reason, HasSubstr("15 x 200"));
  EXPECT_THAT(result.verdicts[5].reason, HasSubstr("no camera"));
  EXPECT_THAT(result.verdicts[6].reason, HasSubstr("unturned"));
  EXPECT_THAT(result.verdicts[7].reason, HasSubstr("No such file"));
}

TEST(ImportPhotos, FailsWhenNothingIsLeft) {
  const ScratchFolder folder;
  EXPECT_THROW(import({}, {}), Error);
  EXPECT_THROW(import({folder / "missing.png"}, {}), Error);
  EXPECT_THROW(import(write_photos(folder, 1), {camera_named("other")}), Error);
}

TEST(ImportPhotos, FailsWhenTwoCamerasShareAName) {
  const ScratchFolder folder;
  EXPECT_THROW(import(write_photos(folder, 1), {camera_named("photo0"), camera_named("photo0")}),
               Error);
}

TEST(ImportPhotos, GuessesTheLensFromExifWithoutCameras) {
  const ScratchFolder folder;
  PhotoFile file{.width = 360, .height = 240};
  ASSERT_TRUE(write_photo(folder / "bare.jpg", file));
  file.attributes.attribute("Exif:FocalLengthIn35mmFilm", 50);
  ASSERT_TRUE(write_photo(folder / "exif.jpg", file));
  const PhotoImport result = import({folder / "bare.jpg", folder / "exif.jpg"}, {});
  // 50 mm before film 36 mm wide; the film's diagonal is rounded to 43.2666 mm
  EXPECT_NEAR(result.photos[1].camera.lens.focal_px.x, 360.0 * 50.0 / 36.0, 1e-3);
  EXPECT_DOUBLE_EQ(result.photos[0].camera.lens.focal_px.y, 1.2 * 360.0);
  EXPECT_EQ(result.photos[0].camera.lens.principal_px, glm::dvec2(179.5, 119.5));
  EXPECT_THAT(result.verdicts[0].reason, HasSubstr("assumed"));
}

TEST(ImportPhotos, KeepsAlphaBesideThePhoto) {
  const ScratchFolder folder;
  const PhotoFile file{.channels = 4, .straight_alpha = true, .value = [](int, int, int c) {
                         return c == 3 ? 0.2f : 0.6f;
                       }};
  ASSERT_TRUE(write_photo(folder / "a.png", file));
  const PhotoImport result = import({folder / "a.png"}, {camera_named("a")});
  ASSERT_EQ(result.rgba.size(), 1u);
  EXPECT_NEAR(result.rgba[0](20, 15).a, 0.2f, 1e-5f);
  EXPECT_NEAR(result.photos[0].srgb(20, 15).r, 0.6f, 1e-4f);
}

TEST(ImportPhotos, SameWithOneThreadAndMany) {
  const ScratchFolder folder;
  const auto files = write_photos(folder, 4);
  const PhotoImport many = import(files, cameras_for(4));
  const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
  const PhotoImport one = import(files, cameras_for(4));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(one.photos[i].srgb, many.photos[i].srgb);
}

TEST(ImportPhotos, StopsWhenCancelled) {
  const ScratchFolder folder;
  const auto files = write_photos(folder, 4);
  Progress progress(
      [&](const ProgressReport& report) {
        if (report.phrase == "Reading photos") progress.cancel();
      },
      {});
  EXPECT_THROW(import_photos(files, {}, {}, progress), Cancelled);
}

TEST(PhotoOptions, AreDescribedWithTheirDefaultsInRange) {
  PhotoOptions options;
  for (const Option& option : describe(options)) {
    EXPECT_NO_THROW(set_value(option, value_text(option))) << option.name;
  }
}

}  // namespace
}  // namespace bosk
