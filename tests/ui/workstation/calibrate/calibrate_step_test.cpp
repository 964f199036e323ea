#include "ui/workstation/calibrate/calibrate_step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/photo/camera_files.h"
#include "tests/ui/workstation/small_capture.h"
#include "ui/widgets/keys.h"
#include "ui/workstation/guide.h"

namespace bosk {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CalibrateStep : public SmallCaptureStep {
 protected:
  CalibrateStep() {
    hand.drop({capture.photos()});
    EXPECT_TRUE(hand.settle());
    hand.click("step/calibrate");
  }

  CalibrateStepState& state() { return hand.workspace().calibrate; }
  void type_cameras(const fs::path& path) {
    hand.click("calibrate/path");
    hand.type(path.string());
    hand.click("calibrate/import");
    ASSERT_TRUE(hand.settle());
  }
  void expect_said(const std::string& words) { expect_told(state().said, words); }
};

TEST_F(CalibrateStep, TypedCamerasAreMatchedAndImportedInOneEdit) {
  type_cameras(capture.cameras());
  expect_said("10 of 10 photos have a camera");
  EXPECT_EQ(workspace().project().absolute(workspace().project().cameras), capture.cameras());
  ASSERT_TRUE(workspace().capture);
  EXPECT_EQ(guide_of(workspace(), WorkStep::calibrate).state, "ready");
  hand.click("undo");
  EXPECT_TRUE(workspace().project().cameras.empty());
  EXPECT_EQ(workspace().project().photos.size(), 10u);
  EXPECT_FALSE(hand.sees("calibrate/view"));
}

TEST_F(CalibrateStep, DroppedCamerasAreImportedFromAnyStep) {
  workspace().step = WorkStep::export_tree;
  hand.drop({capture.cameras()});
  ASSERT_TRUE(hand.settle());
  EXPECT_EQ(workspace().step, WorkStep::calibrate);
  expect_said("10 of 10 photos have a camera");
}

TEST_F(CalibrateStep, PhotosWithoutACameraAreNamed) {
  std::vector<Camera> cameras = read_cameras(capture.cameras());
  cameras.erase(cameras.begin() + 3);
  write_cameras(cameras, "colmap", capture.scratch / "model");
  type_cameras(capture.scratch / "model");
  expect_said("9 of 10 photos have a camera; without: 003");
  EXPECT_TRUE(hand.sees("calibrate/frustum/004"));
  EXPECT_FALSE(hand.sees("calibrate/frustum/003"));
}

TEST_F(CalibrateStep, AWrongFileSaysWhyAndChangesNothing) {
  std::ofstream(capture.scratch / "transforms.json") << "{ no json";
  type_cameras(capture.scratch / "transforms.json");
  expect_said("transforms.json");
  EXPECT_EQ(state().said.at(0).tone, Tone::bad);
  EXPECT_TRUE(workspace().project().cameras.empty());
}

TEST_F(CalibrateStep, CamerasOfOtherPhotosAreRefusedByName) {
  std::vector<Camera> cameras = read_cameras(capture.cameras());
  for (Camera& camera : cameras) camera.name = "elm_" + camera.name;
  write_cameras(cameras, "transforms", capture.scratch / "elm.json");
  type_cameras(capture.scratch / "elm.json");
  expect_said("0 of 10 photos have a camera");
  expect_said("elm_000");
  EXPECT_TRUE(workspace().project().cameras.empty());
}

TEST_F(CalibrateStep, WithoutPhotosTheImportIsDisabledWithAReason) {
  hand.click("undo");
  EXPECT_FALSE(hand.is_enabled("calibrate/import"));
  hand.drop({capture.cameras()});
  ASSERT_TRUE(hand.settle());
  expect_said("Add the photos first");
}

class ImportedCameras : public CalibrateStep {
 protected:
  ImportedCameras() { type_cameras(capture.cameras()); }
  ImVec2 middle() { return hand.at("calibrate/view").middle(); }
};

TEST_F(ImportedCameras, ADragTurnsTheViewAndTheWheelComesNearer) {
  const OrbitView before = state().view;
  hand.drag(middle(), {middle().x + 80.0f, middle().y + 30.0f});
  EXPECT_NE(state().view.heading, before.heading);
  EXPECT_GT(state().view.elevation, before.elevation);
  hand.wheel(2.0f);
  EXPECT_LT(state().view.distance, before.distance);
  hand.key(kKeyHome);
  EXPECT_EQ(state().view, before);
}

TEST_F(ImportedCameras, AMiddleDragMovesTheView) {
  const OrbitView before = state().view;
  hand.drag(middle(), {middle().x + 60.0f, middle().y}, 8, 2);
  EXPECT_NE(state().view.target, before.target);
  EXPECT_EQ(state().view.heading, before.heading);
}

TEST_F(ImportedCameras, AClickOnAPictureSelectsIt) {
  hand.click("calibrate/frustum/002");
  ASSERT_FALSE(state().selected.empty());
  // What is in front counts; from outside that may be another picture, so a second look is taken at
  // the one that was hit
  const std::string hit = state().selected;
  EXPECT_TRUE(hand.sees("calibrate/selected"));
  hand.click("calibrate/row/" + hit);
  EXPECT_EQ(state().selected, hit);
}

TEST_F(ImportedCameras, ARowSelectsItsPhotoAndOpensIt) {
  hand.click("calibrate/row/001");
  EXPECT_EQ(state().selected, "001");
  hand.frame();
  hand.click("calibrate/open");
  EXPECT_EQ(workspace().step, WorkStep::photos);
  EXPECT_EQ(workspace().photos.shown.stem(), "001");
}

TEST_F(ImportedCameras, ADragSelectsNothing) {
  const ImVec2 from = hand.at("calibrate/frustum/002").middle();
  hand.drag(from, {from.x + 40.0f, from.y});
  EXPECT_TRUE(state().selected.empty());
}

TEST_F(ImportedCameras, OneLooksThroughACameraUntilADrag) {
  hand.click("calibrate/row/002");
  hand.frame();
  hand.click("calibrate/through");
  EXPECT_EQ(state().through, "002");
  hand.frame();
  // Its own picture then stands in the middle of the view
  const ImVec2 at = hand.at("calibrate/frustum/002").middle();
  EXPECT_NEAR(at.x, middle().x, 2.0f);
  EXPECT_NEAR(at.y, middle().y, 2.0f);
  hand.drag(middle(), {middle().x + 50.0f, middle().y});
  EXPECT_TRUE(state().through.empty());
}

TEST_F(ImportedCameras, AWorldOnItsHeadIsTold) {
  std::vector<Camera> cameras = read_cameras(capture.cameras());
  const glm::dmat3 over(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
  for (Camera& camera : cameras) {
    camera.camera_from_world.rotation = camera.camera_from_world.rotation * over;
  }
  write_cameras(cameras, "transforms", capture.scratch / "over.json");
  type_cameras(capture.scratch / "over.json");
  EXPECT_EQ(state().known.cameras.size(), 10u);
  EXPECT_LT(state().known.cameras[0].centre_in_world().z, 0.0);
  EXPECT_TRUE(hand.sees("calibrate/view"));
}

TEST_F(ImportedCameras, ThereIsNothingToCompareBeforeAVolume) {
  EXPECT_THAT(obstacle_to_differences(workspace()), HasSubstr("nothing to compare yet"));
  EXPECT_TRUE(state().differences.by_name.empty());
}

TEST_F(ImportedCameras, MattesOfOtherPhotosThanTheVolumesAreNotCompared) {
  const auto photo_named = [](const std::string& name) {
    Photo photo;
    photo.name = name;
    return photo;
  };
  workspace().results.views =
      std::make_shared<const Photos>(Photos{photo_named("000"), photo_named("001")});
  workspace().results.mattes = std::make_shared<const Mattes>(Mattes{{"001", {}}});
  EXPECT_THAT(obstacle_to_differences(workspace()), HasSubstr("other photos than the volume"));
}

}  // namespace
}  // namespace bosk
