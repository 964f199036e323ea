#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/calibrate/solve.h"
#include "orbit.h"

namespace bosk {
namespace {

using testing::HasSubstr;
using testing::Not;

// Twelve photos of ten markers with half a pixel of noise: whatever is wrong is what a test adds.
Orbit clean_orbit(std::uint64_t seed) {
  return make_orbit({.seed = seed, .photos = 12, .markers = 10, .gross = 0.0, .missing = 0.0});
}

Calibration solve(const Orbit& orbit, bool known = true, double focal_ratio = 1.0) {
  Progress progress;
  Survey survey;
  survey.tapes = {exact_tape(orbit, orbit.names[0], orbit.names[1])};
  Lens lens = known ? orbit.lens : guessed_orbit_lens(orbit);
  lens.focal_px *= focal_ratio;
  return solve_cameras(orbit.photos, survey, {lens, known}, {}, progress);
}

void expect_left_out(const Orbit& orbit, const std::string& photo, const std::string& reason) {
  const Calibration calibration = solve(orbit);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  const PhotoFinding& finding = finding_of(calibration, photo);
  EXPECT_EQ(finding.fate, PhotoFate::refused);
  EXPECT_THAT(finding.reason, HasSubstr(reason));
  EXPECT_EQ(calibration.cameras.size(), orbit.photos.size() - 1);
  EXPECT_LT(orbit_errors(orbit, calibration).worst_crown_px, 3.0);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("photo " + photo));
}

TEST(Diagnosis, ACleanWalkGetsNoComplaint) {
  const Orbit orbit = clean_orbit(1);
  Progress progress;
  Survey survey;
  survey.heights = exact_heights(orbit);
  const Calibration calibration =
      solve_cameras(orbit.photos, survey, {orbit.lens, true}, {}, progress);
  EXPECT_EQ(calibration.verdict, Verdict::good) << sentences_of(calibration);
  EXPECT_TRUE(calibration.sentences.empty()) << sentences_of(calibration);
}

TEST(Diagnosis, AMirroredPhotoIsNamed) {
  Orbit orbit = clean_orbit(2);
  for (Sighting& sighting : orbit.photos[4].sightings)
    sighting.pixel.x = orbit.lens.width_px - 1 - sighting.pixel.x;
  expect_left_out(orbit, "oak_04", "is mirrored");
}

TEST(Diagnosis, APhotoOfAnotherTreeIsNamed) {
  Orbit orbit = clean_orbit(3);
  const Orbit other = clean_orbit(103);
  orbit.photos[7].sightings = other.photos[2].sightings;
  expect_left_out(orbit, "oak_07", "another tree");
}

TEST(Diagnosis, ACroppedPhotoIsNamed) {
  Orbit orbit = clean_orbit(4);
  for (Sighting& sighting : orbit.photos[3].sightings) sighting.pixel -= glm::dvec2(420.0, -310.0);
  expect_left_out(orbit, "oak_03", "cropped");
}

TEST(Diagnosis, AZoomedPhotoIsNamed) {
  Orbit orbit = clean_orbit(5);
  Camera zoomed = orbit.cameras[6];
  zoomed.lens.focal_px *= 1.4;
  orbit.photos[6].sightings = exact_sightings(orbit, zoomed).sightings;
  expect_left_out(orbit, "oak_06", "focal length 40 % longer");
}

TEST(Diagnosis, ACopyIsNamed) {
  Orbit orbit = clean_orbit(6);
  orbit.photos[9].sightings = orbit.photos[8].sightings;
  expect_left_out(orbit, "oak_09", "copy of oak_08");
}

TEST(Diagnosis, APhotoOfAnotherSizeIsNamed) {
  Orbit orbit = clean_orbit(7);
  orbit.photos[2].width_px = 1632;
  orbit.photos[2].height_px = 1224;
  expect_left_out(orbit, "oak_02", "1632 x 1224");
}

TEST(Diagnosis, APhotoWithThreeSightingsIsRefusedAndWithFourUncertain) {
  Orbit orbit = clean_orbit(8);
  orbit.photos[1].sightings.resize(4);
  orbit.photos[5].sightings.resize(3);
  const Calibration calibration = solve(orbit);
  EXPECT_EQ(finding_of(calibration, "oak_05").fate, PhotoFate::refused);
  EXPECT_EQ(finding_of(calibration, "oak_01").fate, PhotoFate::uncertain);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("mark more points in it"));
}

TEST(Diagnosis, APhotoOfWhichMoreThanAThirdDoesNotFitIsUncertain) {
  Orbit orbit = clean_orbit(9);
  auto& sightings = orbit.photos[6].sightings;
  ASSERT_GE(sightings.size(), 8u);
  sightings.resize(8);
  for (std::size_t i = 0; i < 3; ++i)
    sightings[i].pixel += glm::dvec2(60.0, -45.0 - 20.0 * double(i));
  const Calibration calibration = solve(orbit, true);
  const PhotoFinding& finding = finding_of(calibration, "oak_06");
  EXPECT_EQ(finding.outliers, 3);
  EXPECT_EQ(finding.fate, PhotoFate::uncertain);
  EXPECT_NE(finding.reason.find("3 of its 8 sightings"), std::string::npos) << finding.reason;
}

TEST(Diagnosis, TwoNamesExchangedAreNamed) {
  Orbit orbit = clean_orbit(9);
  auto& sightings = orbit.photos[5].sightings;
  std::swap(sightings[0].pixel, sightings[2].pixel);
  const Calibration calibration = solve(orbit);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("red and blue are exchanged in photo oak_05"));
  EXPECT_LT(orbit_errors(orbit, calibration).worst_crown_px, 3.0);
}

TEST(Diagnosis, AMarkerMovedBetweenShotsIsNamed) {
  Orbit orbit = clean_orbit(10);
  Orbit after = orbit;
  after.points[3] += glm::dvec3(0.3, -0.2, 0.0);
  for (std::size_t i = 8; i < orbit.photos.size(); ++i)
    orbit.photos[i] = exact_sightings(after, orbit.cameras[i]);
  const Calibration calibration = solve(orbit);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("yellow was moved between the photos"));
  EXPECT_THAT(sentences_of(calibration), HasSubstr("0.36 m away"));
}

TEST(Diagnosis, MarkersOnALineAreRefusedInWords) {
  Orbit orbit = clean_orbit(11);
  for (std::size_t i = 0; i < orbit.points.size(); ++i)
    orbit.points[i] = {0.2 * double(i) - 1.0, 0.1 * double(i), 0.3 + 0.15 * double(i)};
  for (std::size_t i = 0; i < orbit.photos.size(); ++i)
    orbit.photos[i] = exact_sightings(orbit, orbit.cameras[i]);
  const Calibration calibration = solve(orbit);
  EXPECT_EQ(calibration.verdict, Verdict::refused);
  EXPECT_TRUE(calibration.cameras.empty());
  EXPECT_THAT(sentences_of(calibration), HasSubstr("straight line"));
}

TEST(Diagnosis, OnePhotoIsRefusedInWords) {
  Orbit orbit = clean_orbit(12);
  orbit.photos.resize(1);
  const Calibration calibration = solve(orbit);
  EXPECT_EQ(calibration.verdict, Verdict::refused);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("12 or more"));
}

TEST(Diagnosis, TooFewPointsAreRefusedInWords) {
  Orbit orbit = clean_orbit(13);
  for (PhotoSightings& photo : orbit.photos) photo.sightings.resize(3);
  const Calibration calibration = solve(orbit);
  EXPECT_EQ(calibration.verdict, Verdict::refused);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("mark the same points in more photos"));
}

TEST(Diagnosis, PhotosFromOnePlaceAreRefused) {
  Orbit orbit = clean_orbit(14);
  for (std::size_t i = 0; i < orbit.photos.size(); ++i) {
    Camera turned = orbit.cameras[0];
    const double angle = 0.02 * double(i);
    const glm::dmat3 pan(std::cos(angle), 0.0, -std::sin(angle), 0.0, 1.0, 0.0, std::sin(angle),
                         0.0, std::cos(angle));
    turned.camera_from_world = {pan * turned.camera_from_world.rotation,
                                pan * turned.camera_from_world.translation};
    turned.name = orbit.photos[i].photo;
    orbit.photos[i] = exact_sightings(orbit, turned);
  }
  const Calibration calibration = solve(orbit);
  EXPECT_EQ(calibration.verdict, Verdict::refused) << sentences_of(calibration);
}

TEST(Diagnosis, AFocalLengthThatExifGetsWrongIsFoundAndSaid) {
  Orbit orbit = clean_orbit(15);
  for (const double ratio : {0.7, 1.3}) {
    for (PhotoSightings& photo : orbit.photos) photo.exif_focal_px = ratio * orbit.lens.focal_px.x;
    const Calibration calibration = solve(orbit, false, ratio);
    ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
    EXPECT_NEAR(calibration.lens.focal_px.x / orbit.lens.focal_px.x, 1.0, 0.02);
    EXPECT_THAT(sentences_of(calibration), HasSubstr("EXIF is wrong"));
  }
}

TEST(Diagnosis, ExifIsNotBlamedWhereThereIsNone) {
  Orbit orbit = clean_orbit(15);
  for (PhotoSightings& photo : orbit.photos) photo.exif_focal_px.reset();
  const Calibration calibration = solve(orbit, false, 1.3);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_NEAR(calibration.lens.focal_px.x / orbit.lens.focal_px.x, 1.0, 0.02);
  EXPECT_THAT(sentences_of(calibration), Not(HasSubstr("EXIF")));
}

TEST(Diagnosis, AKnownLensThatIsWrongIsSaid) {
  const Orbit orbit = clean_orbit(16);
  const Calibration calibration = solve(orbit, true, 1.3);
  EXPECT_NE(calibration.verdict, Verdict::good);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("known lens"));
}

TEST(Diagnosis, NoiseBeyondWhatSightingsClaimWidensTheirErrors) {
  Orbit orbit = make_orbit(
      {.seed = 17, .photos = 12, .markers = 10, .noise_px = 3.0, .gross = 0.0, .missing = 0.0});
  const Calibration calibration = solve(orbit);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  double sum = 0.0;
  for (const PhotoFinding& finding : calibration.photos) sum += finding.crown_sigma_px;
  EXPECT_GT(sum / 12.0, 1.5);  // about six times the 0.5 of half a pixel
}

// Walks that determine little. Whatever is given as placed lies where its sigma says.
TEST(Diagnosis, NoPoorWalkIsSilentlyWrong) {
  const std::vector<OrbitOptions> poor = {
      {.seed = 18, .photos = 10, .markers = 4, .missing = 0.0},
      {.seed = 19, .photos = 10, .markers = 5, .fewest_sightings = 4},
      {.seed = 20, .photos = 10, .missing = 0.6, .fewest_sightings = 3},
      {.seed = 21, .photos = 4},
      {.seed = 22, .photos = 10, .turns = 0.1},
  };
  for (const OrbitOptions& options : poor) {
    const Orbit orbit = make_orbit(options);
    const Calibration calibration = solve(orbit, false);
    EXPECT_NE(calibration.verdict, Verdict::good);
    EXPECT_FALSE(calibration.sentences.empty());
    if (calibration.verdict == Verdict::refused) continue;
    const OrbitErrors errors = orbit_errors(orbit, calibration);
    for (std::size_t i = 0; i < errors.crown_px.size(); ++i) {
      const PhotoFinding& finding = finding_of(calibration, calibration.cameras[i].name);
      if (finding.fate != PhotoFate::placed) continue;
      EXPECT_LT(errors.crown_px[i], std::max(2.0, 4.0 * finding.crown_sigma_px))
          << "seed " << options.seed << " " << finding.photo;
    }
  }
}

}  // namespace
}  // namespace bosk
