#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/photo/camera_files.h"
#include "tests/photo/random_cameras.h"
#include "tests/photo/refusal.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace testing_cameras;
using ::testing::HasSubstr;

const std::string kOneImage = "7 1 0 0 0 1 2 3 1 a/tree.jpg\n\n";

CameraFile read_text_model(const std::string& cameras, const std::string& images) {
  const TemporaryFolder folder;
  folder.write("cameras.txt", cameras);
  folder.write("images.txt", images);
  return read_camera_file(folder.path());
}

std::string refusal_of_model(const std::string& cameras, const std::string& images = kOneImage) {
  return refusal_of([&] { read_text_model(cameras, images); });
}

Lens lens_of(const std::string& model_and_rest) {
  return read_text_model("1 " + model_and_rest + "\n", kOneImage).cameras[0].lens;
}

TEST(ColmapText, ReadsEveryModelIntoOpenCvsParameters) {
  const auto lens = [](LensModel model, dvec2 focal, std::array<double, 8> distortion) {
    return Lens{model, 640, 480, focal, dvec2(319.5, 239.5), distortion};
  };
  EXPECT_EQ(lens_of("SIMPLE_PINHOLE 640 480 500 320 240"),
            lens(LensModel::pinhole, dvec2(500), {}));
  EXPECT_EQ(lens_of("PINHOLE 640 480 500 501 320 240"), lens(LensModel::pinhole, {500, 501}, {}));
  EXPECT_EQ(lens_of("SIMPLE_RADIAL 640 480 500 320 240 .1"),
            lens(LensModel::opencv, dvec2(500), {.1}));
  EXPECT_EQ(lens_of("RADIAL 640 480 500 320 240 .1 .2"),
            lens(LensModel::opencv, dvec2(500), {.1, .2}));
  EXPECT_EQ(lens_of("OPENCV 640 480 500 501 320 240 .1 .2 .3 .4"),
            lens(LensModel::opencv, {500, 501}, {.1, .2, .3, .4}));
  EXPECT_EQ(lens_of("FULL_OPENCV 640 480 500 501 320 240 .1 .2 .3 .4 .5 .6 .7 .8"),
            lens(LensModel::opencv, {500, 501}, {.1, .2, .3, .4, .5, .6, .7, .8}));
  EXPECT_EQ(lens_of("OPENCV_FISHEYE 640 480 500 501 320 240 .1 .2 .3 .4"),
            lens(LensModel::opencv_fisheye, {500, 501}, {.1, .2, .3, .4}));
  EXPECT_EQ(lens_of("SIMPLE_RADIAL_FISHEYE 640 480 500 320 240 .1"),
            lens(LensModel::opencv_fisheye, dvec2(500), {.1}));
  EXPECT_EQ(lens_of("RADIAL_FISHEYE 640 480 500 320 240 .1 .2"),
            lens(LensModel::opencv_fisheye, dvec2(500), {.1, .2}));
}

TEST(ColmapText, TheMiddleOfTheImageLiesBetweenTheMiddlePixels) {
  // COLMAP's principal point of a centred 4 x 2 image is (2, 1): the corner between pixels 1 and 2.
  const auto file = read_text_model("1 SIMPLE_PINHOLE 4 2 3 2 1\n", kOneImage);
  EXPECT_EQ(file.cameras[0].lens.principal_px, dvec2(1.5, 0.5));
}

TEST(ColmapText, PoseIsCameraFromWorldWithTheQuaternionsRealPartFirst) {
  // A quarter turn about z: x becomes y.
  const auto file =
      read_text_model("1 SIMPLE_PINHOLE 4 2 3 2 1\n",
                      "1 0.70710678118654752 0 0 0.70710678118654752 1 2 3 1 a.png\n\n");
  const dvec3 moved = file.cameras[0].camera_from_world * dvec3(10, 0, 0);
  EXPECT_LT(glm::length(moved - dvec3(1, 12, 3)), 1e-14);
}

TEST(ColmapText, TakesCommentsBlanksWindowsLinesAndPoints) {
  const auto file = read_text_model("# cameras\r\n  1   SIMPLE_PINHOLE 4 2  3 2 1 \r\n\r\n",
                                    "# images\r\n1 1 0 0 0 0 0 0 1 my photo 1.jpg\r\n"
                                    "10.5 20.5 -1 3 4 5\r\n2 1 0 0 0 0 0 0 1 b.jpg\r\n\r\n");
  ASSERT_EQ(file.cameras.size(), 2u);
  EXPECT_EQ(file.cameras[0].name, "my photo 1");
  EXPECT_EQ(file.images[0], "my photo 1.jpg");
  EXPECT_EQ(file.cameras[1].name, "b");
}

TEST(ColmapText, TakesFilesWithoutLinesOfPoints) {
  const auto file =
      read_text_model("1 SIMPLE_PINHOLE 4 2 3 2 1\n",
                      "1 1 0 0 0 0 0 0 1 a.jpg\n2 1 0 0 0 0 0 0 1 b.jpg\n3 1 0 0 0 0 0 0 1 c.jpg");
  EXPECT_EQ(file.cameras.size(), 3u);
}

TEST(ColmapText, NormalisesAQuaternionWithFewDigitsAndRefusesAnother) {
  const std::string cameras = "1 SIMPLE_PINHOLE 4 2 3 2 1\n";
  const auto file = read_text_model(cameras, "1 0.707 0 0 0.707 1 2 3 1 a.png\n\n");
  EXPECT_NEAR(glm::determinant(file.cameras[0].camera_from_world.rotation), 1.0, 1e-14);
  EXPECT_THAT(refusal_of_model(cameras, "1 0.8 0 0 0.8 1 2 3 1 a.png\n\n"),
              HasSubstr("images.txt, line 1: the quaternion has length 1.13"));
  EXPECT_THAT(refusal_of_model(cameras, "1 0 0 0 0 1 2 3 1 a.png\n\n"), HasSubstr("length 0"));
}

TEST(ColmapText, RefusesModelsItLacksByName) {
  EXPECT_THAT(refusal_of_model("1 FOV 640 480 500 501 320 240 .1\n"),
              HasSubstr("cameras.txt, line 1: the camera model \"FOV\" is not supported"));
}

TEST(ColmapText, RefusesNumbersThatCantBe) {
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 -3 3 2 1\n"), HasSubstr("line 1: the focal length"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 3 1e300 2 1\n"), HasSubstr("the focal length"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 nan 3 2 1\n"), HasSubstr("\"nan\" is not a number"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 inf 3 2 1\n"), HasSubstr("\"inf\" is not a number"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 1e999 3 2 1\n"), HasSubstr("\"1e999\""));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 3,5 3 2 1\n"), HasSubstr("\"3,5\""));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 100001 2 3 3 2 1\n"), HasSubstr("image size"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 0 2 3 3 2 1\n"), HasSubstr("image size"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 3 3 2\n"), HasSubstr("4 parameters, not 3"));
  EXPECT_THAT(refusal_of_model("1 PINHOLE 4 2 3 3 2 1 0\n"), HasSubstr("4 parameters, not 5"));
  EXPECT_THAT(refusal_of_model("x PINHOLE 4 2 3 3 2 1\n"), HasSubstr("\"x\" is not a whole"));
}

TEST(ColmapText, RefusesModelsThatContradictThemselves) {
  const std::string cameras = "1 SIMPLE_PINHOLE 4 2 3 2 1\n";
  EXPECT_THAT(refusal_of_model(cameras + cameras), HasSubstr("listed twice"));
  EXPECT_THAT(refusal_of_model(cameras, "1 1 0 0 0 0 0 0 2 a.jpg\n\n"),
              HasSubstr("camera 2 is not among"));
  EXPECT_THAT(refusal_of_model(cameras,
                               "1 1 0 0 0 0 0 0 1 left/a.jpg\n\n2 1 0 0 0 0 0 0 1 right/a.jpg\n\n"),
              HasSubstr("two images are named \"a\""));
  EXPECT_THAT(refusal_of_model(cameras, "# nothing\n"), HasSubstr("no camera in it"));
  EXPECT_THAT(refusal_of_model(cameras, "1 1 0 0 0 0 0 0 1 \n\n"),
              HasSubstr("no name of an image"));
  EXPECT_THAT(refusal_of_model(cameras, "1 1 0 0 0 0 0 0 1 ../..\n\n"), HasSubstr("no name"));
}

TEST(ColmapBinary, SaysTheSameAsText) {
  Random random(1);
  const auto cameras = random_cameras(
      random, 20, {LensModel::pinhole, LensModel::opencv, LensModel::opencv_fisheye});
  const TemporaryFolder text, binary;
  write_cameras(cameras, "colmap", text.path());
  write_cameras(cameras, "colmap-binary", binary.path());
  const auto a = read_cameras(text.path()), b = read_cameras(binary.path());
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].lens, b[i].lens);
    EXPECT_EQ(a[i].camera_from_world.rotation, b[i].camera_from_world.rotation);
    EXPECT_EQ(a[i].camera_from_world.translation, b[i].camera_from_world.translation);
  }
}

template <class T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// A model of one SIMPLE_RADIAL camera and one image with two points, put together by hand from
// COLMAP's description of its format.
struct HandMadeModel {
  std::string cameras = bytes_of(std::uint64_t(1)) + bytes_of(std::uint32_t(9)) +
                        bytes_of(std::int32_t(2)) + bytes_of(std::uint64_t(640)) +
                        bytes_of(std::uint64_t(480)) + bytes_of(500.0) + bytes_of(320.0) +
                        bytes_of(240.0) + bytes_of(0.1);
  std::string images = bytes_of(std::uint64_t(1)) + bytes_of(std::uint32_t(4)) + bytes_of(1.0) +
                       bytes_of(0.0) + bytes_of(0.0) + bytes_of(0.0) + bytes_of(1.0) +
                       bytes_of(2.0) + bytes_of(3.0) + bytes_of(std::uint32_t(9)) +
                       std::string("a/tree.jpg\0", 11) + bytes_of(std::uint64_t(2)) +
                       std::string(48, '\1');

  std::vector<Camera> read() const {
    const TemporaryFolder folder;
    folder.write("cameras.bin", cameras);
    folder.write("images.bin", images);
    return read_cameras(folder.path());
  }
};

TEST(ColmapBinary, ReadsAModelByteByByte) {
  const auto cameras = HandMadeModel().read();
  ASSERT_EQ(cameras.size(), 1u);
  EXPECT_EQ(cameras[0].name, "tree");
  EXPECT_EQ(cameras[0].lens,
            (Lens{LensModel::opencv, 640, 480, dvec2(500.0), dvec2(319.5, 239.5), {0.1}}));
  EXPECT_EQ(cameras[0].camera_from_world.translation, dvec3(1, 2, 3));
}

TEST(ColmapBinary, RefusesEveryCut) {
  const HandMadeModel whole;
  for (std::size_t size = 0; size < whole.cameras.size(); ++size) {
    HandMadeModel cut = whole;
    cut.cameras.resize(size);
    EXPECT_THAT(refusal_of([&] { cut.read(); }), HasSubstr("cameras.bin")) << size;
  }
  for (std::size_t size = 0; size < whole.images.size(); ++size) {
    HandMadeModel cut = whole;
    cut.images.resize(size);
    EXPECT_THAT(refusal_of([&] { cut.read(); }), HasSubstr("images.bin")) << size;
  }
}

TEST(ColmapBinary, RefusesCountsThatTheFileCantHold) {
  for (const std::uint64_t count : {std::uint64_t(2), std::uint64_t(1) << 31,
                                    (std::uint64_t(1) << 32) - 1, std::uint64_t(1) << 63}) {
    HandMadeModel model;
    model.images.replace(0, 8, bytes_of(count));
    EXPECT_THAT(refusal_of([&] { model.read(); }), HasSubstr("images.bin"));
    model = {};
    model.images.replace(model.images.size() - 56, 8, bytes_of(count + 1));
    EXPECT_THAT(refusal_of([&] { model.read(); }), HasSubstr("images.bin"));
  }
}

TEST(ColmapBinary, RefusesModelsItLacksByName) {
  HandMadeModel model;
  model.cameras.replace(12, 4, bytes_of(std::int32_t(10)));
  EXPECT_THAT(refusal_of([&] { model.read(); }), HasSubstr("THIN_PRISM_FISHEYE is not supported"));
  model.cameras.replace(12, 4, bytes_of(std::int32_t(-5)));
  EXPECT_THAT(refusal_of([&] { model.read(); }), HasSubstr("number -5 is not supported"));
}

}  // namespace
}  // namespace bosk
