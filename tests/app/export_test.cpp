// What a project gives to other programs can be read back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/photo/camera_files.h"
#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;

class Export : public testing::Test {
 protected:
  void SetUp() override {
    make_tiny_capture(folder / "capture");
    run_bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json", "--mattes",
              "capture/mattes", "--quiet"},
             folder.path());
  }
  ProgramEnd export_to(const std::string& format, const std::string& output) const {
    return run_bosk({"export", "p", "--to", format, output, "--quiet"}, folder.path());
  }

  ScratchFolder folder;
};

TEST_F(Export, CamerasAreThoseThatCameIn) {
  const auto original = read_cameras(folder / "capture" / "transforms.json");
  for (const std::string format : {"colmap", "colmap-binary", "transforms", "cameramodel"}) {
    const ProgramEnd end = export_to(format, "out-" + format);
    ASSERT_EQ(end.status, 0) << end.err;
    const auto cameras = read_cameras(folder / ("out-" + format));
    ASSERT_EQ(cameras.size(), original.size()) << format;
    for (const Camera& camera : cameras) {
      const auto same = std::find_if(original.begin(), original.end(), [&](const Camera& other) {
        return other.name == camera.name;
      });
      ASSERT_NE(same, original.end()) << format << " " << camera.name;
      const double apart = glm::length(camera.centre_in_world() - same->centre_in_world());
      EXPECT_LT(apart, 1e-6) << format;  // metres; text formats keep 17 digits, quaternions round
    }
  }
}

TEST_F(Export, MattesServeAsMattesAgain) {
  ASSERT_EQ(export_to("mattes", "mattes").status, 0);
  const ProgramEnd made = run_bosk({"new", "q", "capture/photos", "--cameras",
                                    "capture/transforms.json", "--mattes", "mattes", "--quiet"},
                                   folder.path());
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(run_bosk({"matte", "q", "--quiet"}, folder.path()).status, 0);
}

}  // namespace
}  // namespace bosk
