#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/photo/camera_files.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

class WritePhantom : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    PhantomOptions options = tiny_phantom();
    options.photos = 3;
    options.board_photos = 1;
    options.scribbled_photos = 2;
    Progress quiet;
    made = std::make_unique<Phantom>(make_phantom(options, quiet));
  }
  static void TearDownTestSuite() { made.reset(); }
  void SetUp() override {
    folder = fs::temp_directory_path() / ("bosk-phantom-" + std::to_string(::getpid()));
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  static inline std::unique_ptr<Phantom> made;
  const Phantom& phantom = *made;
  Progress progress;
  fs::path folder;
};

TEST_F(WritePhantom, LaysOutEveryFile) {
  write_phantom(folder, phantom, progress);
  for (const char* file :
       {"photos/000.jpg", "photos/002.jpg", "mattes/002.png", "heldout/001.png", "board/000.jpg",
        "scribbles/000.png", "scribbles/001.png", "transforms.json", "transforms_heldout.json",
        "transforms_board.json", "density.npy", "truth.json"}) {
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  }
  EXPECT_EQ(fs::file_size(folder / "density.npy"), 128u + 32u * 32u * 32u * 4u);
}

TEST_F(WritePhantom, WritesCamerasThatReadBack) {
  write_phantom(folder, phantom, progress);
  const CameraFile file = read_camera_file(folder / "transforms.json");
  ASSERT_EQ(file.cameras.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Camera& truth = phantom.photos[i].camera;
    const auto expected = project(truth, {0.1, 0.2, 1.0}),
               read = project(file.cameras[i], {0.1, 0.2, 1.0});
    EXPECT_LT(glm::distance(*expected, *read), 1e-5);  // the file keeps pixels to 1e-6
    EXPECT_TRUE(fs::exists(file.images[i])) << file.images[i];
  }
}

TEST_F(WritePhantom, TellsTheTruthInJson) {
  write_phantom(folder, phantom, progress);
  std::ifstream stream(folder / "truth.json");
  const auto truth = nlohmann::json::parse(stream);
  EXPECT_EQ(truth["options"]["preset"], "dense");
  ASSERT_EQ(truth["markers"].size(), 6u);
  EXPECT_EQ(truth["markers"][0]["xyz"][2], phantom.markers[0].centre.z);
  EXPECT_EQ(truth["photos"][1]["markers"][2]["x"], phantom.photos[1].marker_px[2].x);
}

TEST_F(WritePhantom, SaysWhichFolderItCannotMake) {
  fs::create_directories(folder);
  write_file_atomically(folder / "blocker", std::string_view("x"));
  const fs::path blocked = folder / "blocker" / "inside";
  try {
    write_phantom(blocked, phantom, progress);
    FAIL() << "a file stands in the way";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("blocker"), std::string::npos);
  }
}

}  // namespace
}  // namespace bosk
