#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/photo/camera_files.h"
#include "tests/photo/random_cameras.h"
#include "tests/photo/refusal.h"

namespace bosk {
namespace {

using glm::dvec2;
using glm::dvec3;
using namespace testing_cameras;
using ::testing::HasSubstr;

const std::string kIdentity = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";
const std::string kLens = R"("w":640,"h":480,"fl_x":500,"cx":320,"cy":240,)";

std::string frame(const std::string& more = "", const std::string& matrix = kIdentity) {
  return R"({"file_path":"images/a.jpg",)" + more + R"("transform_matrix":)" + matrix + "}";
}

std::string file_with(const std::string& lens, const std::string& frames = frame()) {
  return "{" + lens + R"("frames":[)" + frames + "]}";
}

CameraFile read_json(const std::string& text, const ImageSizeLookup& size = {}) {
  const TemporaryFolder folder;
  return read_camera_file(folder.write("transforms.json", text), size);
}

Camera only_camera(const std::string& text) { return read_json(text).cameras.at(0); }
std::string refusal_of_json(const std::string& text) {
  return refusal_of([&] { read_json(text); });
}

TEST(TransformsJson, ReadsInstantNgpsKeys) {
  const Camera camera = only_camera(file_with(
      R"("camera_angle_x":0.9,"fl_x":500,"fl_y":510,"k1":0.1,"k2":0.2,"k3":0.5,"p1":0.3,"p2":0.4,
         "is_fisheye":false,"cx":320,"cy":240,"w":640.0,"h":480.0,"aabb_scale":16,)"));
  EXPECT_EQ(camera.name, "a");
  EXPECT_EQ(camera.lens, (Lens{LensModel::opencv,
                               640,
                               480,
                               dvec2(500, 510),
                               dvec2(319.5, 239.5),
                               {.1, .2, .3, .4, .5}}));
}

TEST(TransformsJson, ReadsNerfstudiosModels) {
  const std::string k = R"("k1":0.1,"k2":0.2,"k3":0.3,"k4":0.4,)";
  EXPECT_EQ(
      only_camera(file_with(kLens + k + R"("camera_model":"OPENCV_FISHEYE",)")).lens,
      (Lens{
          LensModel::opencv_fisheye, 640, 480, dvec2(500), dvec2(319.5, 239.5), {.1, .2, .3, .4}}));
  EXPECT_EQ(only_camera(file_with(kLens + R"("camera_model":"PINHOLE","k1":0.0,)")).lens.model,
            LensModel::pinhole);
  EXPECT_EQ(only_camera(file_with(kLens + R"("camera_model":"OPENCV","k1":0,)")).lens.model,
            LensModel::opencv);
  EXPECT_THAT(refusal_of_json(file_with(kLens + R"("camera_model":"EQUIRECTANGULAR",)")),
              HasSubstr("key \"camera_model\": \"EQUIRECTANGULAR\" is not supported"));
  EXPECT_THAT(refusal_of_json(file_with(kLens + k + R"("camera_model":"OPENCV",)")),
              HasSubstr("k4 to k6 mean different things"));
}

TEST(TransformsJson, AFramesOwnLensComesFirst) {
  const auto file = read_json(file_with(kLens, frame(R"("fl_x":700,"k1":0.1,)") +
                                                   R"(,{"file_path":"b.png","transform_matrix":)" +
                                                   kIdentity + "}"));
  EXPECT_EQ(file.cameras[0].lens.focal_px, dvec2(700));
  EXPECT_EQ(file.cameras[0].lens.model, LensModel::opencv);
  EXPECT_EQ(file.cameras[1].lens.focal_px, dvec2(500));
  EXPECT_EQ(file.cameras[1].lens.model, LensModel::pinhole);
}

TEST(TransformsJson, TakesNerfsSizesFromTheImages) {
  const std::string nerf = R"({"camera_angle_x":0.6911112070083618,"frames":[
    {"file_path":"./train/r_0","rotation":0.01,"transform_matrix":)" +
                           kIdentity + "}]}";
  const TemporaryFolder folder;
  const auto json = folder.write("transforms_train.json", nerf);
  const auto image = folder.write("train/r_0.png", "not looked into");
  std::filesystem::path asked;
  const CameraFile file = read_camera_file(json, [&](const std::filesystem::path& path) {
    asked = path;
    return std::optional(glm::ivec2(800, 600));
  });
  EXPECT_EQ(asked, image);
  EXPECT_EQ(file.images[0], image);
  EXPECT_EQ(file.cameras[0].name, "r_0");
  EXPECT_EQ(file.cameras[0].lens.principal_px, dvec2(399.5, 299.5));
  EXPECT_NEAR(file.cameras[0].lens.focal_px.x, 1111.1110311937682,
              1e-9);  // the value NeRF's code gets
  EXPECT_EQ(file.cameras[0].lens.focal_px.y, file.cameras[0].lens.focal_px.x);
}

TEST(TransformsJson, AsksForWAndHWhereTheImageIsMissing) {
  EXPECT_THAT(refusal_of_json(file_with(R"("camera_angle_x":0.7,)")), HasSubstr("add w and h"));
}

TEST(TransformsJson, NamesKeepDotsAndLoseFolders) {
  const auto name = [](const std::string& path) {
    return only_camera("{" + kLens + R"("frames":[{"file_path":")" + path +
                       R"(","transform_matrix":)" + kIdentity + "}]}")
        .name;
  };
  EXPECT_EQ(name("./images/IMG.0001.JPG"), "IMG.0001");
  EXPECT_EQ(name("view.05"), "view.05");
  EXPECT_EQ(name("..\\\\shots\\\\a.jpg"), "a");
}

TEST(TransformsJson, CameraLooksAlongMinusZOfTheMatrix) {
  // NeRF's camera at (0, 0, 4) with identity axes looks down at the origin, its y axis up.
  const Camera camera =
      only_camera(file_with(kLens, frame("", "[[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]")));
  EXPECT_EQ(camera.centre_in_world(), dvec3(0, 0, 4));
  EXPECT_EQ(*project(camera, dvec3(0, 0, 0)), dvec2(319.5, 239.5));
  EXPECT_EQ(*project(camera, dvec3(0.4, 0, 0)), dvec2(369.5, 239.5));  // right
  EXPECT_EQ(*project(camera, dvec3(0, 0.4, 0)), dvec2(319.5, 189.5));  // up
  EXPECT_FALSE(project(camera, dvec3(0, 0, 5)));
}

TEST(TransformsJson, AppliedTransformIsUndone) {
  // nerfstudio turns COLMAP's world by this matrix before it writes the poses.
  const std::string applied = R"("applied_transform":[[1,0,0,0],[0,0,1,0],[0,-1,0,0]],)";
  const std::string scaled_too = applied + R"("applied_scale":2.0,)";
  const std::string pose = "[[1,0,0,6],[0,1,0,8],[0,0,1,10],[0,0,0,1]]";
  const Camera turned = only_camera(file_with(kLens + applied, frame("", pose)));
  // (6, 8, 10) = applied (6, -10, 8)
  EXPECT_EQ(turned.centre_in_world(), dvec3(6, -10, 8));
  const Camera original =
      only_camera(file_with(kLens, frame("", "[[1,0,0,6],[0,0,-1,-10],[0,1,0,8],[0,0,0,1]]")));
  EXPECT_EQ(turned.camera_from_world.rotation, original.camera_from_world.rotation);
  const Camera small = only_camera(file_with(kLens + scaled_too, frame("", pose)));
  EXPECT_EQ(small.centre_in_world(), dvec3(3, -5, 4));
}

TEST(TransformsJson, GivesImageAndMaskBesideTheFile) {
  const TemporaryFolder folder;
  const auto json = folder.write("capture/transforms.json",
                                 file_with(kLens, frame(R"("mask_path":"../masks/a.png",)")));
  const CameraFile file = read_camera_file(json);
  EXPECT_EQ(file.images[0], folder.path() / "capture/images/a.jpg");
  EXPECT_EQ(file.masks[0], folder.path() / "masks/a.png");
}

TEST(TransformsJson, StraightensAMatrixWithFewDigitsAndRefusesAnother) {
  const Camera camera = only_camera(file_with(
      kLens, frame("", "[[0.7071,-0.7071,0,0],[0.7071,0.7071,0,0],[0,0,1,0],[0,0,0,1]]")));
  EXPECT_NEAR(glm::determinant(camera.camera_from_world.rotation), 1.0, 1e-14);
  const std::string place = "frame 0, key \"transform_matrix\"";
  for (const std::string matrix :
       {"[[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]", "[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]",
        "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]", "[[1,0,0,0],[0,1,0,0]]", "7",
        "[[1,0,0,0],[0,1,0,0],[0,0,\"1\",0],[0,0,0,1]]",
        "[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,1]]"})
    EXPECT_THAT(refusal_of_json(file_with(kLens, frame("", matrix))), HasSubstr(place)) << matrix;
}

TEST(TransformsJson, RefusesNumbersThatCantBe) {
  const auto with = [](const std::string& more) {
    return refusal_of_json(file_with(kLens, frame(more)));
  };
  EXPECT_THAT(with(R"("fl_x":-5,)"), HasSubstr("frame 0: the focal length"));
  EXPECT_THAT(with(R"("w":100001,)"), HasSubstr("image size"));
  EXPECT_THAT(with(R"("w":12.5,)"), HasSubstr("image size"));
  EXPECT_THAT(with(R"("cx":"320",)"), HasSubstr("key \"cx\": a finite number"));
  EXPECT_THAT(with(R"("cx":1e999,)"), HasSubstr("no valid JSON"));
  EXPECT_THAT(with(R"("cx":NaN,)"), HasSubstr("no valid JSON"));
  EXPECT_THAT(refusal_of_json(file_with(R"("w":4,"h":2,)")), HasSubstr("add fl_x"));
  EXPECT_THAT(refusal_of_json(file_with(R"("w":4,"h":2,"camera_angle_x":3.5,)")),
              HasSubstr("between 0 and pi"));
}

TEST(TransformsJson, RefusesOtherJson) {
  EXPECT_THAT(refusal_of_json(""), HasSubstr("no valid JSON"));
  EXPECT_THAT(refusal_of_json("[]"), HasSubstr("no transforms.json"));
  EXPECT_THAT(refusal_of_json("{}"), HasSubstr("no transforms.json"));
  EXPECT_THAT(refusal_of_json(R"({"frames":7})"), HasSubstr("no transforms.json"));
  EXPECT_THAT(refusal_of_json(R"({"frames":[]})"), HasSubstr("no camera in it"));
  EXPECT_THAT(refusal_of_json(R"({"frames":[7]})"), HasSubstr("frame 0: an object"));
  EXPECT_THAT(
      refusal_of_json("{" + kLens + R"("frames":[{"transform_matrix":)" + kIdentity + "}]}"),
      HasSubstr("add it"));
  EXPECT_THAT(refusal_of_json(file_with(kLens, frame() + "," + frame())),
              HasSubstr("two images are named \"a\""));
}

TEST(TransformsJson, RefusesDeepNesting) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(refusal_of_json(R"({"x":)" + deep + "}"), HasSubstr("deeper than 64"));
  EXPECT_THAT(refusal_of_json(std::string(100000, '[')), HasSubstr("deeper than 64"));
}

}  // namespace
}  // namespace bosk
