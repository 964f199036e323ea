#include "core/calibrate/lens_pictures.h"

#include <gtest/gtest.h>

#include "tests/calibrate/painted_board.h"

namespace bosk {
namespace {

bool is_red(const glm::u8vec3& colour) {
  return colour.r > colour.g + 60 && colour.r > colour.b + 60;
}
bool is_green(const glm::u8vec3& colour) { return colour.g > colour.r + 40; }

LensCalibration left_half_seen() {
  LensCalibration calibration;
  calibration.profile.lens = phone_lens(1600, 1200);
  calibration.profile.coverage = Image<float>(4, 3, 20.0f);
  for (int y = 0; y < 3; ++y)
    for (int x = 2; x < 4; ++x) calibration.profile.coverage(x, y) = 0.0f;
  calibration.corner_sigma_px = 0.1;
  calibration.residuals = {{0, 0, 0, {400, 300}, {0.0, 0.0}, false},
                           {0, 1, 0, {400, 900}, {7.0, 0.0}, true}};
  return calibration;
}

TEST(CoveragePicture, ShowsWhereBoardsLackAndWhichCornersAreOff) {
  const auto picture = coverage_picture(left_half_seen(), 320);
  ASSERT_EQ(picture.width(), 320);
  ASSERT_EQ(picture.height(), 240);
  EXPECT_TRUE(is_red(picture(300, 120)));
  EXPECT_FALSE(is_red(picture(20, 20)));
  EXPECT_TRUE(is_green(picture(80, 60)));
  EXPECT_TRUE(is_red(picture(80, 180)));
}

TEST(UncertaintyPicture, GoesFromBlueToRed) {
  LensProfile profile;
  profile.lens = phone_lens(1600, 1200);
  profile.uncertainty_px = Image<float>(16, 12);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x) profile.uncertainty_px(x, y) = float(x) / 15.0f;
  const auto picture = uncertainty_picture(profile, 160);
  EXPECT_GT(picture(2, 60).b, picture(2, 60).r);
  EXPECT_TRUE(is_red(picture(158, 60)));
}

TEST(CalibrationPictures, OfACalibrationThatFailedAreRed) {
  EXPECT_TRUE(is_red(coverage_picture({}, 40)(20, 20)));
  EXPECT_TRUE(is_red(uncertainty_picture({}, 40)(20, 20)));
}

}  // namespace
}  // namespace bosk
