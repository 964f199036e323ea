#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/photo/import.h"
#include "tests/base/scratch_folder.h"
#include "tests/hostile_input/damaged_photos.h"
#include "tests/photo/photo_writer.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

// Names would collide: "noise.jpg" and "noise.png" are one photo to the importer.
fs::path under_own_name(const fs::path& folder, const DamagedPhoto& photo, std::size_t number) {
  fs::path link = folder / (std::to_string(number) + "_" + fs::path(photo.name).stem().string() +
                            fs::path(photo.name).extension().string());
  fs::rename(folder / photo.name, link);
  return link;
}

TEST(DamagedPhotos, EachHasAVerdictAndTheGoodOnesAreImported) {
  const ScratchFolder folder;
  const std::vector<DamagedPhoto> damaged = make_damaged_photos(folder.path());
  EXPECT_GE(damaged.size(), 40u);
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < damaged.size(); ++i) {
    files.push_back(under_own_name(folder.path(), damaged[i], i));
    if (i % 10 != 0) continue;
    files.push_back(folder / ("good" + std::to_string(i) + ".png"));
    ASSERT_TRUE(write_photo(files.back(), {.width = 200 + int(i), .height = 150}));
  }

  Progress quiet;
  const PhotoImport import = import_photos(files, {}, {}, quiet);
  ASSERT_EQ(import.verdicts.size(), files.size());
  std::size_t next = 0;
  for (const PhotoVerdict& verdict : import.verdicts) {
    EXPECT_FALSE(verdict.reason.empty()) << verdict.file;
    if (verdict.name.starts_with("good")) {
      EXPECT_TRUE(verdict.accepted) << verdict.name << ": " << verdict.reason;
      continue;
    }
    const Fate fate = damaged[next++].fate;
    if (fate == Fate::either) continue;
    EXPECT_EQ(verdict.accepted, fate == Fate::read) << verdict.name << ": " << verdict.reason;
  }
  for (const Photo& photo : import.photos) {
    for (const glm::vec3& pixel : photo.srgb.pixels()) {
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(pixel, glm::vec3(0.0f))) &&
                  glm::all(glm::lessThanEqual(pixel, glm::vec3(1.0f))))
          << photo.name;
    }
  }
}

TEST(DamagedPhotos, AreRefusedAsMattesWithAReasonToo) {
  const ScratchFolder folder;
  const Progress quiet;
  PhotoDecoder decoder;
  for (const DamagedPhoto& photo : make_damaged_photos(folder.path())) {
    if (photo.fate != Fate::refused || photo.name.starts_with("cut_to_3")) continue;
    if (photo.name == "one_pixel.png" || photo.name == "ribbon.png") continue;
    EXPECT_THROW(decoder.decode_matte(folder / photo.name, quiet), Error) << photo.name;
  }
}

}  // namespace
}  // namespace bosk
