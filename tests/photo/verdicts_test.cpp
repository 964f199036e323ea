#include "core/photo/verdicts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/base/scratch_folder.h"
#include "tests/photo/photo_writer.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Camera camera_named(const std::string& name, int width, int height) {
  Camera camera;
  camera.name = name;
  camera.lens.width_px = width;
  camera.lens.height_px = height;
  camera.lens.focal_px = glm::dvec2(width);
  camera.lens.principal_px = 0.5 * (glm::dvec2(width, height) - 1.0);
  return camera;
}

// One of each kind: sound, copy, namesake, damaged, too small, without focal length, not there.
std::vector<fs::path> mixed_files(const ScratchFolder& folder) {
  fs::create_directory(folder / "other");
  PhotoFile sound{.width = 60};
  sound.attributes.attribute("Exif:FocalLengthIn35mmFilm", 50.0f);
  write_photo(folder / "a.jpg", sound);
  fs::copy_file(folder / "a.jpg", folder / "b.jpg");
  write_photo(folder / "other" / "a.png", {.width = 50});
  std::ofstream(folder / "c.jpg") << "\xff\xd8\xff this is no photo";
  write_photo(folder / "d.png", {.width = 8, .height = 8});
  write_photo(folder / "e.png", {.width = 44});
  return {folder / "a.jpg", folder / "b.jpg", folder / "other" / "a.png", folder / "c.jpg",
          folder / "d.png", folder / "e.png", folder / "gone.jpg"};
}

std::vector<PhotoFacts> looked_through(const std::vector<fs::path>& files) {
  PhotoDecoder decoder;
  const Progress quiet;
  std::vector<PhotoFacts> facts;
  for (const fs::path& file : files) {
    facts.push_back(look_through(file, decoder, quiet));
    facts.back().decoded.pixels = {};
  }
  return facts;
}

void expect_as_imported(const std::vector<fs::path>& files, const std::vector<Camera>& cameras) {
  Progress quiet;
  const auto imported = import_photos(files, cameras, {}, quiet).verdicts;
  const auto verdicts = photo_verdicts(looked_through(files), cameras, {});
  ASSERT_EQ(verdicts.size(), imported.size());
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    EXPECT_EQ(verdicts[i].accepted, imported[i].accepted) << files[i];
    EXPECT_EQ(verdicts[i].reason, imported[i].reason) << files[i];
    EXPECT_EQ(verdicts[i].content, imported[i].content) << files[i];
  }
}

TEST(PhotoVerdicts, AreThoseOfTheImportWithoutCameras) {
  const ScratchFolder folder;
  expect_as_imported(mixed_files(folder), {});
}

TEST(PhotoVerdicts, AreThoseOfTheImportWithCameras) {
  const ScratchFolder folder;
  // e has another shape than its camera, and the rest but a have none
  expect_as_imported(mixed_files(folder), {camera_named("a", 60, 30), camera_named("e", 44, 44)});
}

TEST(PhotoVerdicts, ChangeWithTheCamerasAndWithoutAnotherLook) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_photo(folder / "a.png", {.width = 40, .height = 30}));
  const std::vector<PhotoFacts> facts = looked_through({folder / "a.png"});
  fs::remove(folder / "a.png");
  EXPECT_THAT(photo_verdicts(facts, {}, {})[0].reason, HasSubstr("no focal length in EXIF"));
  const std::vector<Camera> turned = {camera_named("a", 30, 40)};
  EXPECT_THAT(photo_verdicts(facts, turned, {})[0].reason, HasSubstr("its camera 30 x 40"));
}

}  // namespace
}  // namespace bosk
