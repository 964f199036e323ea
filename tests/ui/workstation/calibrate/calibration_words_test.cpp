#include "ui/workstation/calibrate/calibration_words.h"

#include <gtest/gtest.h>

namespace bosk {
namespace {

Calibration two_points() {
  Calibration calibration;
  calibration.scale_known = true;
  calibration.points = {{"red", {0, 0, 1.502}, glm::dmat3(0.0), 2, 0.1},
                        {"blue", {2, 0, 1.502}, glm::dmat3(0.0), 2, 0.1}};
  return calibration;
}

TEST(TapeWords, SayHowFarTheSolveIsFromTheTape) {
  EXPECT_EQ(tape_words(two_points(), {"red", "blue", 1.996, 0.002}),
            "solved 2.000 m, +4.0 mm (2.0 sigma)");
  EXPECT_EQ(height_words(two_points(), {"red", 1.507, 0.005}),
            "solved 1.502 m, -5.0 mm (1.0 sigma)");
}

TEST(TapeWords, SayNoMinusOfNothing) {
  EXPECT_EQ(tape_words(two_points(), {"red", "blue", 2.00000001, 0.002}),
            "solved 2.000 m, +0.0 mm (0.0 sigma)");
}

TEST(TapeWords, AreNoneWithoutAPlaceOrAScale) {
  EXPECT_FALSE(tape_words(two_points(), {"red", "post", 2.0, 0.002}));
  Calibration unscaled = two_points();
  unscaled.scale_known = false;
  EXPECT_FALSE(tape_words(unscaled, {"red", "blue", 2.0, 0.002}));
}

TEST(ObstacleToTape, NamesWhatIsMissing) {
  EXPECT_EQ(obstacle_to_tape({"red", "", 0.0, 0.002}), "choose the points at both ends");
  EXPECT_EQ(obstacle_to_tape({"red", "red", 1.0, 0.002}), "choose two different points");
  EXPECT_EQ(obstacle_to_tape({"red", "blue", 0.0, 0.002}), "type the length in metres");
  EXPECT_EQ(obstacle_to_tape({"red", "blue", 1.0, 0.002}), "");
}

TEST(TroubledPhotos, AreCountedAndNamed) {
  Calibration calibration;
  for (const auto& [name, fate] :
       {std::pair("003", PhotoFate::uncertain), std::pair("004", PhotoFate::placed),
        std::pair("007", PhotoFate::uncertain)}) {
    PhotoFinding photo;
    photo.photo = name;
    photo.fate = fate;
    calibration.photos.push_back(photo);
  }
  EXPECT_EQ(troubled_photos(calibration, PhotoFate::uncertain), "2 photos are uncertain: 003, 007");
  EXPECT_EQ(troubled_photos(calibration, PhotoFate::refused), "");
}

}  // namespace
}  // namespace bosk
