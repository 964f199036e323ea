#include "core/project/left_out.h"

#include <gtest/gtest.h>

#include "core/project/calibration_run.h"
#include "core/project/edit.h"
#include "core/project/project_json.h"

namespace bosk {
namespace {

const Stroke kDisc{StrokeKind::left_out, 10.0, {{50.0, 40.0}}};
const Stroke kLine{StrokeKind::left_out, 3.0, {{10.0, 70.0}, {90.0, 70.0}}};
const Stroke kOfMatte{StrokeKind::background, 8.0, {{1.0, 2.0}}};

TEST(LeftOut, MasksWhatIsWithinTheStrokes) {
  const Image<std::uint8_t> mask = mask_of({kDisc, kLine}, {100, 80}, {100, 80});
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool in_disc = (x - 50) * (x - 50) + (y - 40) * (y - 40) <= 100;
      const double along = std::clamp(double(x), 10.0, 90.0) - x;
      const bool in_line = along * along + (y - 70) * (y - 70) <= 9.0;
      ASSERT_EQ(mask(x, y), in_disc || in_line ? 0 : 255) << x << " " << y;
    }
  }
}

// Half a mask pixel is a photo pixel: that far a centre may be from the stroke's edge.
TEST(LeftOut, MasksReducedPhotosAtTheirOwnPixels) {
  const Image<std::uint8_t> mask = mask_of({kDisc}, {100, 80}, {50, 40});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 50; ++x) {
      const double dx = 2 * x + 0.5 - 50.0, dy = 2 * y + 0.5 - 40.0;
      ASSERT_EQ(mask(x, y), dx * dx + dy * dy <= 100.0 ? 0 : 255) << x << " " << y;
    }
  }
}

TEST(LeftOut, MayReachBeyondThePhoto) {
  const Stroke beyond{StrokeKind::left_out, 30.0, {{-20.0, -500.0}, {-20.0, 500.0}}};
  const Image<std::uint8_t> mask = mask_of({beyond}, {100, 80}, {100, 80});
  EXPECT_EQ(mask(10, 0), 0);
  EXPECT_EQ(mask(11, 79), 255);
}

TEST(LeftOut, TakesFindsAwayAndLeavesClicks) {
  PhotoSightings photo{"oak", 100, 80, {}, {}, {}};
  photo.sightings = {{"red", {55.0, 45.0}, 0.2, SightedBy::ball},
                     {"mine", {50.0, 40.0}, 0.5, SightedBy::click},
                     {"tag 3/0", {80.0, 71.0}, 0.2, SightedBy::tag},
                     {"blue", {50.0, 51.0}, 0.2, SightedBy::ball}};
  leave_out({kDisc, kLine}, photo);
  ASSERT_EQ(photo.sightings.size(), 2u);
  EXPECT_EQ(photo.sightings[0].point, "mine");
  EXPECT_EQ(photo.sightings[1].point, "blue");
}

TEST(LeftOut, KeepsWhatThePersonClickedThere) {
  CalibrationFinds finds;
  finds.photos = {{"oak", 100, 80, {}, {}, {{"red", {50.0, 40.0}, 0.2, SightedBy::ball}}}};
  CalibrationSources sources;
  sources.left_out["oak"] = {kDisc};
  std::vector<std::string> sentences;
  EXPECT_TRUE(told_sightings(finds, sources, sentences)[0].sightings.empty());
  sources.sightings["oak"]["red"] = {true, {50.0, 41.0}};
  const auto told = told_sightings(finds, sources, sentences);
  ASSERT_EQ(told[0].sightings.size(), 1u);
  EXPECT_EQ(told[0].sightings[0].by, SightedBy::click);
}

TEST(LeftOut, IsKeptApartFromTheMattesStrokes) {
  Project project;
  apply(AddStroke{"oak", kOfMatte}, project);
  apply(AddStroke{"oak", kDisc}, project);
  EXPECT_EQ(project.strokes.at("oak"), std::vector<Stroke>{kOfMatte});
  EXPECT_EQ(project.calibration.left_out.at("oak"), std::vector<Stroke>{kDisc});
  const Edit use_all = use_all_edit(project, "oak");
  apply(use_all, project);
  EXPECT_EQ(project.strokes.size(), 1u);
  EXPECT_TRUE(project.calibration.left_out.empty());
  revert(use_all, project);
  EXPECT_EQ(project.calibration.left_out.at("oak"), std::vector<Stroke>{kDisc});
  apply(clear_edit(project, "oak"), project);
  EXPECT_EQ(project.calibration.left_out.size(), 1u);
  revert(AddStroke{"oak", kDisc}, project);
  EXPECT_TRUE(project.calibration.left_out.empty());
}

TEST(LeftOut, ReadsBackFromTheProjectAndRaisesItsSchema) {
  Project project;
  EXPECT_EQ(project_text(project).find("left_out"), std::string::npos);
  project.calibration.left_out["oak"] = {kDisc, kLine};
  const std::string text = project_text(project);
  EXPECT_NE(text.find("\"bosk_project\": 4"), std::string::npos);
  const Project read = project_of_text(std::as_bytes(std::span(text)), "project.json");
  EXPECT_EQ(read.calibration.left_out, project.calibration.left_out);
  EXPECT_TRUE(read.strokes.empty());
}

TEST(LeftOut, IsPartOfWhatTheCalibrationDependsOn) {
  CalibrationSources sources;
  sources.photos = {{"oak", "oak.jpg", {1, 2}}};
  const ContentHash nothing = calibration_key(sources);
  sources.left_out["oak"] = {kDisc};
  const ContentHash disc = calibration_key(sources);
  sources.left_out["oak"][0].radius_px = 11.0;
  EXPECT_NE(disc, nothing);
  EXPECT_NE(calibration_key(sources), disc);
}

}  // namespace
}  // namespace bosk
