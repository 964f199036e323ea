#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/photo/camera_files.h"
#include "tests/photo/mrcal_oracle.h"
#include "tests/photo/random_cameras.h"
#include "tests/photo/refusal.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace testing_cameras;
using ::testing::HasSubstr;

Camera read_model(const std::string& text) {
  const TemporaryFolder folder;
  return read_cameras(folder.write("left.cameramodel", text)).at(0);
}
std::string refusal_of_model(const std::string& text) {
  return refusal_of([&] { read_model(text); });
}

const std::string kRest = "'extrinsics':[0,0,0,1,2,3],'imagersize':[640,480]}";
const std::string kPinhole = "'lensmodel':'LENSMODEL_PINHOLE','intrinsics':[500,501,320,240],";

TEST(Cameramodel, ReadsWhatMrcalWrites) {
  const Camera camera = read_model(R"(# generated on a day with ' and { in it
{
    'lensmodel':  'LENSMODEL_OPENCV8',

    # intrinsics are fx,fy,cx,cy,distortion0,distortion1,....
    'intrinsics': [ 1000, 1001, 500.25, 400.5, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8,],

    'valid_intrinsics_region': [
    [ 1, 2 ],
    [ 3e0, -4.5 ],
],

    # extrinsics are rt_fromref
    'extrinsics': [ 0, 0, 1.5707963267948966, 4, 5, 6,],

    'imagersize': [ 1000, 800,],

    'icam_intrinsics': 0,

    'optimization_inputs': b'P)h>@6aWAK2mo&=\'#{',
}
)");
  EXPECT_EQ(camera.name, "left");
  EXPECT_EQ(camera.lens, (Lens{LensModel::opencv,
                               1000,
                               800,
                               dvec2(1000, 1001),
                               dvec2(500.25, 400.5),
                               {.1, .2, .3, .4, .5, .6, .7, .8}}));
  EXPECT_LT(glm::length(camera.camera_from_world * dvec3(1, 0, 0) - dvec3(4, 6, 6)), 1e-14);
}

TEST(Cameramodel, ReadsEveryLensOfOpenCvs) {
  const auto lens = [](const std::string& model, const std::string& distortion) {
    return read_model("{'lensmodel':'LENSMODEL_" + model + "','intrinsics':[500,501,320,240" +
                      distortion + "]," + kRest)
        .lens;
  };
  EXPECT_EQ(lens("PINHOLE", "").model, LensModel::pinhole);
  EXPECT_EQ(lens("OPENCV4", ",1,2,3,4").distortion, (std::array<double, 8>{1, 2, 3, 4}));
  EXPECT_EQ(lens("OPENCV5", ",1,2,3,4,5").distortion, (std::array<double, 8>{1, 2, 3, 4, 5}));
  EXPECT_EQ(lens("OPENCV8", ",1,2,3,4,5,6,7,8").distortion,
            (std::array<double, 8>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Cameramodel, TakesDoubleQuotesTuplesNamesAndOldKeys) {
  const Camera camera = read_model(
      "{ \"distortion_model\" : \"DISTORTION_\" \"OPENCV4\", \"intrinsics\": "
      "(500,+501,.32e3,240,1,2,3,4),"
      "'other': {'a': None, 'b': [True, (False,), {}]}, " +
      kRest);
  EXPECT_EQ(camera.lens.focal_px, dvec2(500, 501));
  EXPECT_EQ(camera.lens.principal_px, dvec2(320, 240));
}

TEST(Cameramodel, RefusesLensesItLacksByName) {
  const auto expect_refused = [](const std::string& model) {
    EXPECT_THAT(
        refusal_of_model("{'lensmodel':'LENSMODEL_" + model + "','intrinsics':[1,1,1,1]," + kRest),
        HasSubstr("\"LENSMODEL_" + model +
                  "\" is not supported; convert it by "
                  "mrcal-convert-lensmodel"));
  };
  expect_refused("OPENCV12");
  expect_refused("CAHVOR");
  expect_refused("SPLINED_STEREOGRAPHIC_order=3_Nx=30_Ny=18");
}

TEST(Cameramodel, RefusesBrokenText) {
  const auto with = [](const std::string& more) {
    return refusal_of_model("{" + kPinhole + more + kRest);
  };
  EXPECT_EQ(with(""), "(no Error)");
  EXPECT_THAT(with("'a' 1,"), HasSubstr("left.cameramodel, line 1: ':' is missing"));
  EXPECT_THAT(with("\n'a';"), HasSubstr("left.cameramodel, line 2: ':' is missing"));
  EXPECT_THAT(with("'a:1,"), HasSubstr("line 1"));
  EXPECT_THAT(with("'a':[1 2],"), HasSubstr("',' is missing"));
  EXPECT_THAT(with("'a':eval(1),"), HasSubstr("\"eval\" is not a number"));
  EXPECT_THAT(with("'intrinsics':[1,2,3],"), HasSubstr("'intrinsics' must hold 4 numbers, not 3"));
  EXPECT_THAT(with("'intrinsics':[nan,2,3,4],"), HasSubstr("\"nan\""));
  EXPECT_THAT(with("'lensmodel':7,"), HasSubstr("a string must stand here"));
  EXPECT_THAT(refusal_of_model(""), HasSubstr("'{' is missing"));
  EXPECT_THAT(refusal_of_model("{}"), HasSubstr("'lensmodel' is missing"));
  EXPECT_THAT(refusal_of_model("{" + kPinhole + "'imagersize':[1,1]}"),
              HasSubstr("'extrinsics' must hold 6 numbers, not 0"));
  EXPECT_THAT(refusal_of_model("{" + kPinhole + kRest + "}"), HasSubstr("something follows"));
  EXPECT_THAT(with("'a':" + std::string(100000, '[') + ","), HasSubstr("deeper than 64"));
}

TEST(Cameramodel, CantHoldAFisheye) {
  Random random(1);
  const TemporaryFolder folder;
  auto cameras = random_cameras(random, 2, {LensModel::opencv});
  cameras[1].lens = random_lens(random, LensModel::opencv_fisheye);
  EXPECT_THAT(refusal_of([&] { write_cameras(cameras, "cameramodel", folder.path()); }),
              HasSubstr("choose the format colmap or transforms"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Cameramodel, OneFileHoldsOneCamera) {
  Random random(2);
  const TemporaryFolder folder;
  const auto cameras = random_cameras(random, 2, {LensModel::opencv});
  EXPECT_THAT(
      refusal_of([&] { write_cameras(cameras, "cameramodel", folder.path() / "a.cameramodel"); }),
      HasSubstr("give a folder"));
}

TEST(Cameramodel, MrcalProjectsWhatWeWriteToTheSamePixels) {
  if (!has_mrcal()) GTEST_SKIP() << "libmrcal-dev is not installed";
  Random random(3);
  const TemporaryFolder folder;
  const auto cameras = random_cameras(random, 50, {LensModel::pinhole, LensModel::opencv});
  write_cameras(cameras, "cameramodel", folder.path());
  for (const Camera& camera : cameras) {
    std::vector<dvec3> points;
    points.reserve(20);
    for (int i = 0; i < 20; ++i)
      points.push_back(inverse(camera.camera_from_world) * random_point_in_camera(random));
    const auto pixels = project_with_mrcal(folder.path() / (camera.name + ".cameramodel"), points);
    ASSERT_TRUE(pixels) << camera.name;
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_LT(glm::length((*pixels)[i] - *project(camera, points[i])), 1e-8);
  }
}

TEST(Cameramodel, ReadsWhatMrcalWroteAgain) {
  if (!has_mrcal()) GTEST_SKIP() << "libmrcal-dev is not installed";
  Random random(4);
  const TemporaryFolder folder;
  const auto cameras = random_cameras(random, 20, {LensModel::pinhole, LensModel::opencv});
  write_cameras(cameras, "cameramodel", folder.path());
  for (const Camera& camera : cameras) {
    const auto copy = folder.path() / "copy.cameramodel";
    rewrite_with_mrcal(folder.path() / (camera.name + ".cameramodel"), copy);
    const Camera read = read_cameras(copy).at(0);
    // mrcal writes six decimals: the rotation vector moves by 5e-7 an entry
    EXPECT_LT(glm::length(read.lens.focal_px - camera.lens.focal_px), 1e-6);
    EXPECT_LT(
        glm::length(read.camera_from_world.translation - camera.camera_from_world.translation),
        1e-6);
    EXPECT_LT(
        glm::length(read.camera_from_world.rotation[0] - camera.camera_from_world.rotation[0]),
        2e-6);
    EXPECT_EQ(read.lens.model, camera.lens.model);
  }
}

}  // namespace
}  // namespace bosk
