#include "core/project/calibration_run.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/image/image_io.h"
#include "core/project/binary_items.h"
#include "core/project/calibration_figures.h"
#include "core/project/calibration_store.h"
#include "core/project/camera_wheel.h"
#include "core/project/reshoot.h"
#include "core/project/svg_labels.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

Camera camera_at(const std::string& name, double heading, double radius) {
  Camera camera;
  camera.name = name;
  camera.lens.width_px = 100;
  const glm::dvec3 centre(radius * std::cos(heading), radius * std::sin(heading), 1.6);
  camera.camera_from_world.translation = -centre;
  return camera;
}

// Eight photos all round, of which one was not placed and one is uncertain.
Calibration sample() {
  Calibration calibration;
  calibration.verdict = Verdict::usable;
  calibration.sentences = {"photo 3 is not placed: it shows 2 markers; click more"};
  calibration.lens.width_px = 100;
  calibration.scale_known = true;
  calibration.scale_sigma = 0.0015;
  calibration.rms_px = 0.456;
  for (int i = 0; i < 8; ++i) {
    PhotoFinding photo;
    photo.photo = std::to_string(i);
    photo.sightings = 6;
    photo.centre_covariance_m2 = glm::dmat3(1e-4);
    if (i == 3) photo.fate = PhotoFate::refused;
    if (i == 5) photo.fate = PhotoFate::uncertain;
    photo.reason = i == 3 || i == 5 ? "see <why>" : "";
    if (i != 3) calibration.cameras.push_back(camera_at(photo.photo, 0.7854 * i, 6.0));
    calibration.photos.push_back(photo);
  }
  calibration.points = {{"red", {1.0, 2.0, 0.5}, glm::dmat3(1e-6), 7, 0.4},
                        {"f12", {0.0, 0.0, 0.5}, glm::dmat3(1e-6), 3, 0.4}};
  calibration.residuals = {{"0", "red", {1.0, 2.0}, {0.25, -0.5}, true}};
  return calibration;
}

std::vector<std::byte> bytes_of(const Calibration& calibration) {
  BinaryWriter writer;
  write(writer, calibration);
  return writer.bytes();
}

// All that is told of it; its bytes may differ in what pads them.
std::string told_of(const Calibration& calibration) {
  return calibration_figures_json(calibration).dump();
}

CalibrationFinds finds_of(std::vector<Sighting> sightings) {
  CalibrationFinds finds;
  finds.photos = {{"oak", 640, 480, {}, {}, std::move(sightings)}};
  return finds;
}

TEST(ToldSightings, CountOverWhatWasFound) {
  const CalibrationFinds finds = finds_of({{"red", {1, 1}, 0.2, SightedBy::ball},
                                           {"blue", {2, 2}, 0.2, SightedBy::ball},
                                           {"grey", {3, 3}, 0.2, SightedBy::ball}});
  CalibrationSources sources;
  sources.sightings = {{"oak", {{"red", {true, {9, 9}}}, {"blue", {false, {}}}}}};
  std::vector<std::string> sentences;
  const auto photos = told_sightings(finds, sources, sentences);
  ASSERT_EQ(photos[0].sightings.size(), 2u);
  EXPECT_EQ(photos[0].sightings[0].point, "grey");
  EXPECT_EQ(photos[0].sightings[1].point, "red");
  EXPECT_EQ(photos[0].sightings[1].pixel, glm::dvec2(9, 9));
  EXPECT_EQ(photos[0].sightings[1].by, SightedBy::click);
  EXPECT_TRUE(sentences.empty());
}

TEST(ToldSightings, OutsideThePhotoAreSaidAndLeftOut) {
  CalibrationSources sources;
  sources.sightings = {{"oak", {{"red", {true, {640, 9}}}}}};
  std::vector<std::string> sentences;
  const auto photos = told_sightings(finds_of({}), sources, sentences);
  EXPECT_TRUE(photos[0].sightings.empty());
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("outside the photo"), std::string::npos);
}

TEST(CalibrationStore, GivesBackWhatItTook) {
  const auto bytes = bytes_of(sample());
  const auto read = read_all<Calibration>(bytes, read_calibration);
  EXPECT_EQ(told_of(read), told_of(sample()));
  EXPECT_EQ(read.photos[3].fate, PhotoFate::refused);
  EXPECT_EQ(read.residuals[0].error_px, glm::dvec2(0.25, -0.5));
}

TEST(CalibrationStore, RefusesEveryCut) {
  const auto bytes = bytes_of(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(read_all<Calibration>(std::span(bytes).first(size), read_calibration), Error);
  }
}

TEST(StoredCalibration, IsFoundByItsSourcesAndDamagedIsAMiss) {
  const ScratchFolder folder;
  const Cache cache(folder / "cache");
  CalibrationSources sources;
  sources.photos = {{"oak", "oak.jpg", {1, 2}}};
  EXPECT_FALSE(stored_calibration(sources, cache));
  store_calibration(sources, sample(), 1.0, cache);
  const auto stored = stored_calibration(sources, cache);
  ASSERT_TRUE(stored);
  EXPECT_EQ(told_of(*stored), told_of(sample()));
  sources.sightings["oak"]["red"] = {};
  EXPECT_FALSE(stored_calibration(sources, cache));
  sources.sightings.clear();
  const std::vector<std::byte> half(bytes_of(sample()).size() / 2);
  cache.store("calibrate", calibration_key(sources), half, 1.0);
  EXPECT_FALSE(stored_calibration(sources, cache));
}

TEST(RequireCameras, SaysWhyThereAreNone) {
  Calibration calibration = sample();
  EXPECT_NO_THROW(require_cameras(calibration));
  calibration.verdict = Verdict::refused;
  try {
    require_cameras(calibration);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("photo 3 is not placed"), std::string::npos);
  }
}

TEST(CalibrationFigures, BeginWithTheVerdictAndListMarkersButNoFeatures) {
  const std::string text = calibration_figures_text(sample());
  EXPECT_EQ(text.find("usable, with reservations: 7 of 8 photos placed, 0.46 px, scale within "
                      "0.15 %\n  photo 3 is not placed"),
            0u)
      << text;
  EXPECT_NE(text.find("red"), std::string::npos);
  EXPECT_EQ(text.find("f12"), std::string::npos);
}

TEST(CalibrationFigures, FeaturesAreThoseNamedLikeOne) {
  EXPECT_TRUE(is_feature("f12"));
  EXPECT_FALSE(is_feature("f"));
  EXPECT_FALSE(is_feature("fence"));
  EXPECT_FALSE(is_feature("red"));
}

TEST(ReshootPlaces, AreWherePhotosLackOrAreUncertain) {
  const auto places = reshoot_places(sample());
  ASSERT_EQ(places.size(), 3u);
  EXPECT_NE(places[0].why.find("90 degrees without a photo"), std::string::npos) << places[0].why;
  // Half way between its neighbours, and where the uncertain one stands
  const glm::dvec2 between(6.0 * std::cos(0.7854 * 3), 6.0 * std::sin(0.7854 * 3));
  EXPECT_LT(glm::length(places[1].in_world - between), 1e-6);
  const glm::dvec2 there(6.0 * std::cos(0.7854 * 5), 6.0 * std::sin(0.7854 * 5));
  EXPECT_LT(glm::length(places[2].in_world - there), 1e-6);
}

TEST(ReshootPlaces, OfAnEvenWalkAreNone) {
  Calibration calibration = sample();
  calibration.cameras.insert(calibration.cameras.begin() + 3, camera_at("3", 0.7854 * 3, 6.0));
  for (PhotoFinding& photo : calibration.photos) photo.fate = PhotoFate::placed;
  EXPECT_TRUE(reshoot_places(calibration).empty());
}

TEST(CameraWheel, ShowsEveryCameraAndWhereToReshoot) {
  const std::string svg = camera_wheel_svg(sample());
  for (const std::string name : {">0<", ">5<", ">red<", "re-shoot here", "see &lt;why&gt;"}) {
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

// Ninety printed markers in a square of a metre.
Calibration with_a_board(Calibration calibration) {
  for (int i = 0; i < 90; ++i)
    calibration.points.push_back({"tag " + std::to_string(i) + "/0",
                                  {0.1 * (i % 9), 0.1 * (i / 9), 0.0},
                                  glm::dmat3(1e-6),
                                  7,
                                  0.4});
  return calibration;
}

long count_of(const std::string& text, const std::string& part) {
  long count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(CameraWheel, NamesMarkersThatStandCloseOnlyWhereThereIsRoom) {
  const std::string svg = camera_wheel_svg(with_a_board(sample()));
  EXPECT_EQ(count_of(svg, "stroke=\"#333\""), 91);
  EXPECT_GT(count_of(svg, "fill=\"#333\""), 3);
  EXPECT_LT(count_of(svg, "fill=\"#333\""), 60);
}

TEST(SvgLabels, StayWithinTheDrawing) {
  const SvgLabel label[] = {{{95, 50}, "yellow", "#ff0"}};
  const std::string svg = svg_labels(label, 10.0, 5.0, {0, 0}, {100, 100});
  EXPECT_NE(svg.find("x=\"52.8\""), std::string::npos) << svg;  // 95 - 5 - 6 letters of 6.2
}

TEST(WasFound, OnceThePhotosWereLookedThroughWhateverIsClicked) {
  const ScratchFolder scratch;
  const Cache cache(scratch / "cache");
  Image<glm::u8vec3> grey(64, 48);
  write_file_atomically(scratch / "oak.png", png_bytes(grey));
  CalibrationSources sources;
  sources.photos = source_files({{"oak", scratch / "oak.png"}});
  sources.options.features = "off";
  EXPECT_FALSE(was_found(sources, cache));
  Progress quiet;
  find_for_calibration(sources, cache, quiet);
  EXPECT_TRUE(was_found(sources, cache));
  sources.sightings = {{"oak", {{"red", {true, {9, 9}}}}}};
  sources.left_out = {{"oak", {Stroke()}}};
  EXPECT_TRUE(was_found(sources, cache));
  sources.options.balls.smallest_diameter_px += 1.0;
  EXPECT_FALSE(was_found(sources, cache));
}

TEST(StoredCalibration, IsTheRefinedOneOnlyWhereThatIsAskedForAndDone) {
  const ScratchFolder scratch;
  const Cache cache(scratch.path());
  CalibrationSources sources;
  store_calibration(sources, sample(), 1.0, cache);
  sources.options.refine = "silhouettes";
  ASSERT_TRUE(stored_calibration(sources, cache)) << "the solved one serves until then";
  EXPECT_FALSE(stored_refinement(sources, cache));
  Calibration refined = sample();
  refined.cameras[0].camera_from_world.translation.x += 0.25;
  store_refinement(sources, refined, 1.0, cache);
  const auto first_x = [&] {
    return stored_calibration(sources, cache)->cameras[0].camera_from_world.translation.x;
  };
  EXPECT_EQ(first_x(), refined.cameras[0].camera_from_world.translation.x);
  sources.options.refine = "none";
  EXPECT_EQ(first_x(), sample().cameras[0].camera_from_world.translation.x);
}

}  // namespace
}  // namespace bosk
