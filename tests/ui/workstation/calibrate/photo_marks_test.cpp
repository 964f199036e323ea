#include "ui/workstation/calibrate/photo_marks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/workstation/calibrate/loupe.h"
#include "ui/workstation/calibrate/point_colours.h"

namespace bosk {
namespace {

using Kind = PhotoMark::Kind;

// Two photos that show red and blue by themselves, and a feature.
CalibrationFinds two_photos() {
  CalibrationFinds finds;
  for (const std::string name : {"oak_1", "oak_2"}) {
    PhotoSightings photo;
    photo.photo = name;
    photo.width_px = 400;
    photo.height_px = 300;
    photo.sightings = {{"red", {100.0, 50.0}, 0.5, SightedBy::ball},
                       {"blue", {200.0, 60.0}, 0.5, SightedBy::ball},
                       {"f7", {10.0, 20.0}, 0.5, SightedBy::feature}};
    finds.photos.push_back(photo);
  }
  return finds;
}

const PhotoMark* named(const std::vector<PhotoMark>& marks, const std::string& point) {
  for (const PhotoMark& mark : marks) {
    if (mark.point == point) return &mark;
  }
  return nullptr;
}

TEST(PhotoMarks, AHandCountsOverWhatWasFound) {
  const CalibrationFinds finds = two_photos();
  HandSightings told;
  told["oak_1"]["red"] = {true, {101.0, 51.0}};
  told["oak_1"]["blue"] = {false, {}};
  told["oak_1"]["post"] = {true, {5.0, 6.0}};
  const auto marks = marks_of("oak_1", &finds, told, nullptr);
  ASSERT_TRUE(named(marks, "red") && named(marks, "blue") && named(marks, "post"));
  EXPECT_EQ(marks.size(), 4u);
  EXPECT_EQ(named(marks, "red")->kind, Kind::by_hand);
  EXPECT_EQ(named(marks, "red")->pixel, glm::dvec2(101.0, 51.0));
  EXPECT_EQ(named(marks, "blue")->kind, Kind::removed);
  EXPECT_EQ(named(marks, "post")->kind, Kind::by_hand);
  EXPECT_EQ(named(marks_of("oak_2", &finds, told, nullptr), "blue")->kind, Kind::found);
}

TEST(PhotoMarks, ErrorsBelongToThePlaceThatWasSolved) {
  const CalibrationFinds finds = two_photos();
  Calibration solved;
  solved.residuals = {{"oak_1", "red", {100.0, 50.0}, {3.0, 4.0}, true},
                      {"oak_1", "blue", {199.0, 60.0}, {1.0, 0.0}, false}};
  const auto marks = marks_of("oak_1", &finds, {}, &solved);
  ASSERT_TRUE(named(marks, "red")->error_px);
  EXPECT_TRUE(named(marks, "red")->outlier);
  EXPECT_EQ(words_of(*named(marks, "red")), "red, left out: 5.00 px off");
  EXPECT_FALSE(named(marks, "blue")->error_px) << "it was moved since";
}

TEST(PhotoMarks, APointSeenElsewhereIsExpectedWhereItsCameraSeesIt) {
  Calibration solved;
  Camera camera;
  camera.name = "oak_1";
  camera.lens.width_px = 400;
  camera.lens.height_px = 300;
  camera.lens.focal_px = glm::dvec2(500.0);
  camera.lens.principal_px = {199.5, 149.5};
  solved.cameras = {camera};
  solved.points = {{"post", {0.1, 0.0, 5.0}, glm::dmat3(0.0), 2, 0.1},
                   {"behind", {0.0, 0.0, -5.0}, glm::dmat3(0.0), 2, 0.1},
                   {"beside", {9.0, 0.0, 5.0}, glm::dmat3(0.0), 2, 0.1}};
  const auto marks = marks_of("oak_1", nullptr, {}, &solved);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].kind, Kind::expected);
  EXPECT_NEAR(marks[0].pixel.x, 209.5, 1e-9);
  EXPECT_EQ(mark_at(marks, marks[0].pixel, 5.0), nullptr) << "nothing there to take";
}

TEST(PhotoMarks, TheNearestWithinReachIsTakenButNoFeature) {
  const CalibrationFinds finds = two_photos();
  const auto marks = marks_of("oak_1", &finds, {}, nullptr);
  ASSERT_TRUE(mark_at(marks, {103.0, 50.0}, 5.0));
  EXPECT_EQ(mark_at(marks, {103.0, 50.0}, 5.0)->point, "red");
  EXPECT_EQ(mark_at(marks, {106.0, 50.0}, 5.0), nullptr);
  EXPECT_EQ(mark_at(marks, {10.0, 20.0}, 5.0), nullptr);
}

TEST(PointRows, CountPhotosAndLeaveFeaturesOut) {
  const CalibrationFinds finds = two_photos();
  CalibrationInputs told;
  told.sightings["oak_1"]["blue"] = {false, {}};
  told.measurements.tapes = {{"red", "post", 1.0, 0.002}};
  Calibration solved;
  solved.points = {{"red", {0, 0, 1}, glm::dmat3(4e-6), 2, 0.25}};
  const auto rows = points_of(&finds, told, &solved);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].name, "blue");
  EXPECT_EQ(rows[0].photos, 1);
  EXPECT_EQ(rows[1].name, "post");
  EXPECT_EQ(rows[1].photos, 0);
  EXPECT_FALSE(rows[1].rms_px);
  EXPECT_EQ(rows[2].photos, 2);
  EXPECT_EQ(rows[2].rms_px, 0.25);
  EXPECT_NEAR(*rows[2].sigma_m, 2e-3 * std::sqrt(3.0), 1e-12);
}

TEST(RemovalEdit, OutlivesTheNextFindButForgetsWhatOnlyAHandSaw) {
  const CalibrationFinds finds = two_photos();
  Project project;
  project.calibration.sightings["oak_1"]["post"] = {true, {5.0, 6.0}};
  const SetSighting found = removal_edit(project, &finds, "oak_1", "red");
  ASSERT_TRUE(found.after);
  EXPECT_FALSE(found.after->there);
  EXPECT_FALSE(removal_edit(project, &finds, "oak_1", "post").after);
}

TEST(RenamingEdit, ExchangesNamesWhereAPhotoHasBoth) {
  const CalibrationFinds finds = two_photos();
  Project project;
  const std::string photos[] = {"oak_1", "oak_2"};
  apply(renaming_edit(project, &finds, photos, "red", "blue"), project);
  for (const std::string& photo : photos) {
    const auto marks = marks_of(photo, &finds, project.calibration.sightings, nullptr);
    EXPECT_EQ(named(marks, "blue")->pixel, glm::dvec2(100.0, 50.0));
    EXPECT_EQ(named(marks, "red")->pixel, glm::dvec2(200.0, 60.0));
  }
}

TEST(RenamingEdit, ANewNameLeavesNothingOfTheOld) {
  const CalibrationFinds finds = two_photos();
  Project project;
  const std::string photos[] = {"oak_1"};
  apply(renaming_edit(project, &finds, photos, "red", "post"), project);
  const auto marks = marks_of("oak_1", &finds, project.calibration.sightings, nullptr);
  EXPECT_EQ(named(marks, "post")->pixel, glm::dvec2(100.0, 50.0));
  EXPECT_EQ(named(marks, "red")->kind, Kind::removed);
  const auto other = marks_of("oak_2", &finds, project.calibration.sightings, nullptr);
  EXPECT_EQ(named(other, "red")->kind, Kind::found);
}

TEST(RenamingEdit, TakesMeasurementsAlong) {
  const Measurements after =
      renamed({{{"red", "blue", 1.0, 0.002}}, {{"red", 1.5, 0.01}}, {}}, "red", "post");
  EXPECT_EQ(after.tapes[0].from, "post");
  EXPECT_EQ(after.tapes[0].to, "blue");
  EXPECT_EQ(after.heights[0].point, "post");
}

TEST(ColourOfPoint, IsTheOneThatItsNameTells) {
  EXPECT_EQ(colour_of_point("red"), colour_of_point("red foot"));
  EXPECT_NE(colour_of_point("blue"), colour_of_point("light blue"));
  EXPECT_NE(colour_of_point("red"), colour_of_point("reduced"));
  EXPECT_EQ(colour_of_point("post"), colour_of_point("post"));
}

TEST(Loupe, ShowsThePixelUnderTheMouseInItsMiddleAndNothingBeyondTheEdge) {
  Image<glm::u8vec4> picture(4, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) picture(x, y) = glm::u8vec4(x, y, 0, 255);
  }
  const Image<glm::u8vec4> loupe = loupe_of(picture, {3.4, 0.6}, 5);
  EXPECT_EQ(loupe(2, 2), glm::u8vec4(3, 1, 0, 255));
  EXPECT_EQ(loupe(1, 1), glm::u8vec4(2, 0, 0, 255));
  EXPECT_EQ(loupe(3, 2), glm::u8vec4(0));
  EXPECT_EQ(loupe(2, 0), glm::u8vec4(0));
}

}  // namespace
}  // namespace bosk
