#include "ui/workstation/calibrate/camera_measures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/workstation/round_cameras.h"

namespace bosk {
namespace {

using testing::HasSubstr;

// The world turned about its x axis.
std::vector<Camera> turned_by(std::vector<Camera> cameras, double cosine, double sine) {
  const glm::dmat3 turn(glm::dvec3(1, 0, 0), glm::dvec3(0, cosine, sine),
                        glm::dvec3(0, -sine, cosine));
  for (Camera& camera : cameras) {
    camera.camera_from_world.rotation = camera.camera_from_world.rotation * glm::transpose(turn);
  }
  return cameras;
}

int upright(const std::string&) { return 1; }

TEST(CameraMeasures, AreInNumbersThatAPersonCanCheck) {
  const Camera camera = camera_looking("a", {4, 0, 5}, {0, 0, 2});
  const CameraMeasures measures = measures_of(camera, {0, 0, 2});
  EXPECT_EQ(measures.name, "a");
  EXPECT_DOUBLE_EQ(measures.focal_px, 500.0);
  EXPECT_EQ(measures.lens, "pinhole");
  EXPECT_NEAR(measures.distance, 5.0, 1e-9);
  EXPECT_NEAR(measures.height, 5.0, 1e-9);
  EXPECT_NEAR(measures.pitch_deg, -36.8699, 1e-4);  // -asin(3/5)
}

TEST(UpVerdict, TellsAWorldOnItsHeadOrItsSide) {
  const auto cameras = cameras_at({0, 90, 180, 270});
  EXPECT_EQ(up_verdict(cameras, upright), UpVerdict::up);
  EXPECT_EQ(up_verdict(turned_by(cameras, -1, 0), upright), UpVerdict::down);
  EXPECT_EQ(up_verdict(turned_by(cameras, 0, 1), upright), UpVerdict::sideways);
  EXPECT_EQ(up_verdict({}, upright), UpVerdict::unknown);
}

TEST(UpVerdict, GoesByTheUprightPicture) {
  // A camera held upright, whose sensor delivers lying pixels: EXIF 6 turns them to the right, so
  // that up in the photo is the sensor's left
  Camera camera = cameras_at({0})[0];
  glm::dmat3& rotation = camera.camera_from_world.rotation;
  const glm::dmat3 sensor_from_upright(glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0),
                                       glm::dvec3(0, 0, 1));
  rotation = sensor_from_upright * rotation;
  const std::vector<Camera> cameras{camera};
  EXPECT_EQ(up_verdict(cameras, upright), UpVerdict::sideways);
  EXPECT_EQ(up_verdict(cameras, [](const std::string&) { return 6; }), UpVerdict::up);
  EXPECT_EQ(up_verdict(cameras, [](const std::string&) { return 8; }), UpVerdict::down);
}

TEST(MatchWords, NameWhatHasNoCamera) {
  EXPECT_EQ(match_words(22, {"IMG_07", "IMG_12"}),
            "22 of 24 photos have a camera; without: IMG_07, IMG_12");
  EXPECT_EQ(match_words(2, {}), "2 of 2 photos have a camera");
  EXPECT_THAT(match_words(0, std::vector<std::string>(9, "x")), HasSubstr("and 3 more"));
}

}  // namespace
}  // namespace bosk
