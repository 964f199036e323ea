// Damaged camera files are read or refused, and nothing else. BOSK_MUTATIONS sets how many of each
// format are tried (5000 unless set, and at least 100).

#include "core/photo/camera_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/rotation.h"
#include "tests/hostile_input/mutate.h"
#include "tests/photo/random_cameras.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using namespace testing_cameras;

int mutations_per_format() {
  const char* text = std::getenv("BOSK_MUTATIONS");
  return text == nullptr ? 5000 : std::max(100, std::atoi(text));
}

struct Sample {
  std::string format;
  std::vector<std::string> files;  // those that are mutated, one at a time
};
void PrintTo(const Sample& sample, std::ostream* stream) { *stream << sample.format; }

// A frame of every kind of key that the reader knows, with a few cameras written by the program.
const std::string kRichJson = R"({"camera_model":"OPENCV","w":640,"h":480.0,"fl_x":500,"fl_y":501,
 "cx":320.5,"cy":240,"k1":-0.1,"k2":1e-2,"k3":0,"k4":0,"p1":0.001,"p2":null,"is_fisheye":false,
 "applied_transform":[[1,0,0,0],[0,0,1,0],[0,-1,0,0]],"applied_scale":2.0,"aabb_scale":16,
 "frames":[{"file_path":"./images/a b.jpg","mask_path":"masks/a b.png","colmap_im_id":1,
  "transform_matrix":[[1,0,0,0.5],[0,1,0,-2e3],[0,0,1,4],[0,0,0,1]]},
  {"file_path":"images/\u00e9","camera_angle_x":0.7,"camera_model":"OPENCV_FISHEYE","k4":0.1,
  "transform_matrix":[[0,1,0,0],[-1,0,0,0],[0,0,1,4],[0,0,0,1]]}]})";

const std::string kRichModel = R"(# a comment
{ 'lensmodel': "LENSMODEL_" 'OPENCV5', 'intrinsics': (500, +501., 3.2e2, 240, .1, -.2, 3e-3, 0, 1,),
  'valid_intrinsics_region': [[1, 2], [3, 4], [1, 2],], 'x': {'y': None, 'z': [True, b'\'\\']},
  'extrinsics': [0.1, 0.2, 0.3, 4, 5, 6,], 'imagersize': [640, 480,], 'icam_intrinsics': 0 })";

void write_sample(const Sample& sample, const TemporaryFolder& folder) {
  Random random(1);
  std::vector<LensModel> models{LensModel::pinhole, LensModel::opencv};
  if (sample.format != "cameramodel") models.push_back(LensModel::opencv_fisheye);
  write_cameras(random_cameras(random, 4, models), sample.format, folder.path());
  if (sample.format == "transforms") folder.write("rich.json", kRichJson);
  if (sample.format == "cameramodel") folder.write("rich.cameramodel", kRichModel);
}

// What later stages take for granted of every camera.
void expect_usable(const CameraFile& file) {
  ASSERT_FALSE(file.cameras.empty());
  ASSERT_EQ(file.images.size(), file.cameras.size());
  ASSERT_EQ(file.masks.size(), file.cameras.size());
  for (const Camera& camera : file.cameras) {
    EXPECT_FALSE(camera.name.empty());
    EXPECT_EQ(camera.name.find('/'), std::string::npos);
    EXPECT_TRUE(camera.lens.width_px >= 1 && camera.lens.width_px <= 100'000);
    EXPECT_TRUE(camera.lens.height_px >= 1 && camera.lens.height_px <= 100'000);
    EXPECT_TRUE(camera.lens.focal_px.x > 0.0 && std::isfinite(camera.lens.focal_px.x));
    EXPECT_TRUE(camera.lens.focal_px.y > 0.0 && std::isfinite(camera.lens.focal_px.y));
    for (const double k : camera.lens.distortion) EXPECT_TRUE(std::isfinite(k));
    EXPECT_LT(rotation_error(camera.camera_from_world.rotation), 1e-9);
    EXPECT_TRUE(std::isfinite(glm::length(camera.centre_in_world())));
    for (const glm::dvec2 pixel : {glm::dvec2(0.0), camera.lens.principal_px, glm::dvec2(1e5)})
      if (const auto ray = camera_from_pixel(camera.lens, pixel)) {
        EXPECT_NEAR(glm::length(*ray), 1.0, 1e-9);
      }
  }
}

struct Outcome {
  int refused = 0, read = 0;
};

void read_mutation(const fs::path& target, Outcome& outcome) {
  try {
    const CameraFile file = read_camera_file(
        target, [](const fs::path&) { return std::optional(glm::ivec2(640, 480)); });
    expect_usable(file);
    ++outcome.read;
  } catch (const Error& error) {
    EXPECT_GT(std::string(error.what()).size(), 20u);
    ++outcome.refused;
  }  // anything else fails the test
}

class CameraFileMutations : public ::testing::TestWithParam<Sample> {};
INSTANTIATE_TEST_SUITE_P(Formats, CameraFileMutations,
                         ::testing::Values(Sample{"colmap", {"cameras.txt", "images.txt"}},
                                           Sample{"colmap-binary", {"cameras.bin", "images.bin"}},
                                           Sample{"transforms", {"transforms.json", "rich.json"}},
                                           Sample{"cameramodel",
                                                  {"view.0.cameramodel", "rich.cameramodel"}}),
                         [](const auto& instance) {
                           const std::string& format = instance.param.format;
                           return format == "colmap-binary" ? std::string("colmap_binary") : format;
                         });

TEST_P(CameraFileMutations, AreReadOrRefusedAndNothingElse) {
  const TemporaryFolder folder;
  write_sample(GetParam(), folder);
  const bool binary = GetParam().format == "colmap-binary";
  const int all = mutations_per_format();
  Random random(2);
  Outcome outcome;
  for (const std::string& name : GetParam().files) {
    const std::string whole = read_whole(folder.path() / name);
    const int mutations = all / int(GetParam().files.size());
    for (int i = 0; i < mutations && !HasFailure(); ++i) {
      SCOPED_TRACE(name + ", mutation " + std::to_string(i));
      folder.write(name, binary ? mutated_bytes(random, whole) : mutated_text(random, whole));
      read_mutation(folder.path() / name, outcome);
    }
    folder.write(name, whole);
  }
  // The mutations are worth something when they neither all miss nor all hit the format's first
  // mark.
  EXPECT_GT(outcome.refused, all / 10);
  EXPECT_GT(outcome.read, all / 100);
  RecordProperty("refused", outcome.refused);
  RecordProperty("read", outcome.read);
}

}  // namespace
}  // namespace bosk
