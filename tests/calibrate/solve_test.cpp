#include "core/calibrate/solve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/base/error.h"
#include "orbit.h"

namespace bosk {
namespace {

using testing::HasSubstr;

Calibration solve(const Orbit& orbit, const Survey& survey, bool known,
                  const SolveOptions& options = {}) {
  Progress progress;
  const LensKnowledge lens{known ? orbit.lens : guessed_orbit_lens(orbit, 0.94), known};
  return solve_cameras(orbit.photos, survey, lens, options, progress);
}

Survey one_tape(const Orbit& orbit) {
  Survey survey;
  survey.tapes = {exact_tape(orbit, orbit.names[0], orbit.names[1])};
  return survey;
}

double tilt_deg(const Orbit& orbit, const Calibration& calibration) {
  const Camera& camera = calibration.cameras.front();
  const Camera& truth = orbit.cameras[std::size_t(std::stoi(camera.name.substr(4)))];
  const glm::dvec3 up = camera.camera_from_world.rotation[2];
  const glm::dvec3 true_up = truth.camera_from_world.rotation[2];
  return glm::degrees(std::acos(std::min(1.0, glm::dot(up, true_up))));
}

TEST(SolveCameras, PlacesAWalkWithMistakesWithinAMillimetre) {
  const Orbit orbit = make_orbit({});
  const Calibration calibration = solve(orbit, one_tape(orbit), true);
  ASSERT_EQ(calibration.verdict, Verdict::usable) << sentences_of(calibration);  // up is a guess
  EXPECT_TRUE(calibration.scale_known);
  const OrbitErrors errors = orbit_errors(orbit, calibration);
  EXPECT_LT(errors.marker_median_m, 0.0018);  // over 50 seeds the median is 1.1 mm
  EXPECT_LT(errors.worst_crown_px, 3.0);
  EXPECT_LT(std::abs(errors.scale_error), 0.003);  // one tape of 2 m, 2 mm
  EXPECT_EQ(calibration.lens, orbit.lens);
}

TEST(SolveCameras, FindsTheFocalLengthOfAFreeLens) {
  const Orbit orbit = make_orbit({.seed = 2});
  const Calibration calibration = solve(orbit, one_tape(orbit), false);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_NEAR(calibration.lens.focal_px.x / orbit.lens.focal_px.x, 1.0, 0.01);
  EXPECT_LT(orbit_errors(orbit, calibration).marker_median_m, 0.003);
}

TEST(SolveCameras, SeesTheWalkReversedAndUneven) {
  const Orbit orbit = make_orbit(
      {.seed = 3, .photos = 16, .turns = -1.0, .jitter_deg = 30.0, .radius_jitter = 0.3});
  const Calibration calibration = solve(orbit, one_tape(orbit), true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_LT(orbit_errors(orbit, calibration).worst_crown_px, 3.0);
  EXPECT_GE(calibration.cameras.size(), 13u);
}

TEST(SolveCameras, NeedsNoOrderOfThePhotos) {
  Orbit orbit = make_orbit({.seed = 4, .photos = 12, .markers = 12, .gross = 0.0});
  for (std::size_t i = 0; i < orbit.photos.size(); ++i)
    std::swap(orbit.photos[i], orbit.photos[(5 * i + 3) % orbit.photos.size()]);
  const Calibration calibration = solve(orbit, one_tape(orbit), true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_LT(orbit_errors(orbit, calibration).worst_crown_px, 3.0);
}

TEST(SolveCameras, StartsFromFirstPoses) {
  const Orbit orbit = make_orbit({.seed = 5, .photos = 12});
  SolveOptions options;
  for (const Camera& camera : orbit.cameras)
    options.first_poses.push_back({camera.name, camera.camera_from_world});
  const Calibration calibration = solve(orbit, one_tape(orbit), true, options);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_LT(orbit_errors(orbit, calibration).worst_crown_px, 3.0);
}

TEST(SolveCameras, HeightsGiveUpGroundAndScale) {
  const Orbit orbit = make_orbit({.seed = 6, .photos = 16});
  Survey survey;
  survey.heights = exact_heights(orbit);
  const Calibration calibration = solve(orbit, survey, true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_TRUE(calibration.scale_known);
  EXPECT_TRUE(calibration.up_known);
  EXPECT_LT(std::abs(orbit_errors(orbit, calibration).scale_error), 0.01);
  EXPECT_LT(tilt_deg(orbit, calibration), 0.5);
  for (const SolvedPoint& point : calibration.points)
    EXPECT_NEAR(point.in_world.z, orbit.place(point.name).z, 0.02) << point.name;
}

TEST(SolveCameras, SticksGiveUpAndTapesScale) {
  const Orbit orbit = make_orbit({.seed = 7, .photos = 12, .markers = 6, .feet = true});
  const Calibration calibration = solve(orbit, one_tape(orbit), true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_TRUE(calibration.up_known);
  EXPECT_LT(tilt_deg(orbit, calibration), 0.5);
}

TEST(SolveCameras, GravityGivesUp) {
  Orbit orbit = make_orbit({.seed = 8, .photos = 12});
  for (std::size_t i = 0; i < orbit.photos.size(); ++i)
    orbit.photos[i].up_in_camera = orbit.cameras[i].camera_from_world.rotation[2];
  const Calibration calibration = solve(orbit, one_tape(orbit), true);
  ASSERT_EQ(calibration.up_known, true) << sentences_of(calibration);
  EXPECT_LT(tilt_deg(orbit, calibration), 0.5);
}

TEST(SolveCameras, SurveyedPointsGiveTheWorld) {
  const Orbit orbit = make_orbit({.seed = 9, .photos = 12});
  Survey survey;
  for (const std::size_t i : {0u, 2u, 4u, 6u})
    survey.points.push_back({orbit.names[i], orbit.points[i] + glm::dvec3(10.0, 20.0, 1.0), 0.003});
  const Calibration calibration = solve(orbit, survey, true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_TRUE(calibration.scale_known && calibration.up_known);
  for (const SolvedPoint& point : calibration.points)
    EXPECT_LT(glm::distance(point.in_world, orbit.place(point.name) + glm::dvec3(10.0, 20.0, 1.0)),
              0.015);
}

// A board of 0.3 m at the foot of the tree, seen in a third of the photos.
Orbit with_board(Orbit orbit, RigidBody& body) {
  body.name = "board";
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const glm::dvec3 in_body(0.1 * column, 0.1 * row, 0.0);
      body.points.push_back("board " + std::to_string(column) + "," + std::to_string(row));
      body.in_body.push_back(in_body);
      orbit.names.push_back(body.points.back());
      orbit.points.emplace_back(0.6 + 0.8 * in_body.x, 0.6 * in_body.x, 0.5 + in_body.y);
    }
  }
  for (std::size_t i = 0; i < orbit.photos.size(); i += 3)
    for (Sighting& sighting : exact_sightings(orbit, orbit.cameras[i]).sightings)
      if (sighting.point.starts_with("board")) orbit.photos[i].sightings.push_back(sighting);
  return orbit;
}

TEST(SolveCameras, ABoardBesideTheTreeGivesMetres) {
  Survey survey;
  survey.bodies.emplace_back();
  const Orbit orbit = with_board(make_orbit({.seed = 10, .photos = 12}), survey.bodies[0]);
  const Calibration calibration = solve(orbit, survey, true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_TRUE(calibration.scale_known);
  EXPECT_LT(std::abs(orbit_errors(orbit, calibration).scale_error), 0.005);
}

TEST(SolveCameras, AWrongTapeIsNamedAmongGoodOnes) {
  const Orbit orbit = make_orbit({.seed = 11, .photos = 12});
  Survey survey;
  for (const int i : {0, 1, 2, 3})
    survey.tapes.push_back(
        exact_tape(orbit, orbit.names[std::size_t(i)], orbit.names[std::size_t(i) + 4]));
  survey.tapes[1].length_m += 0.1;
  const Calibration calibration = solve(orbit, survey, true);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("the tape from green to orange"));
  EXPECT_NE(calibration.verdict, Verdict::good);
  EXPECT_LT(std::abs(orbit_errors(orbit, calibration).scale_error), 0.003);
}

TEST(SolveCameras, AHeightThatItsFootContradictsIsCalledAHeight) {
  Orbit orbit = make_orbit({.seed = 11, .photos = 12});
  orbit.names.push_back(orbit.names[0] + " foot");
  orbit.points.push_back(glm::dvec3(glm::dvec2(orbit.points[0]), 0.1));
  for (std::size_t i = 0; i < orbit.photos.size(); ++i)
    for (Sighting& sighting : exact_sightings(orbit, orbit.cameras[i]).sightings)
      if (sighting.point == orbit.names.back()) orbit.photos[i].sightings.push_back(sighting);
  Survey survey;
  survey.heights = exact_heights(orbit);
  std::erase_if(survey.heights, [&](const Height& h) { return h.point == orbit.names.back(); });
  const Calibration calibration = solve(orbit, survey, true);
  EXPECT_THAT(sentences_of(calibration),
              HasSubstr("the height of " + orbit.names[0] + " over its foot says"));
}

TEST(SolveCameras, AMeasureOfAPointThatNobodySeesNamesThoseThatAreSeen) {
  const Orbit orbit = make_orbit({.seed = 11, .photos = 12});
  Survey survey = one_tape(orbit);
  survey.heights.push_back({"magenta", 1.0});
  const std::string sentences = sentences_of(solve(orbit, survey, true));
  EXPECT_THAT(sentences, HasSubstr("the height of magenta isn't used"));
  EXPECT_THAT(sentences, HasSubstr("or name one of "));
  EXPECT_THAT(sentences, HasSubstr(orbit.names[0] + ","));
}

TEST(SolveCameras, WithoutMeasuresTheUnitIsTheWalksRadius) {
  const Orbit orbit = make_orbit({.seed = 12, .photos = 12});
  const Calibration calibration = solve(orbit, {}, true);
  ASSERT_NE(calibration.verdict, Verdict::refused) << sentences_of(calibration);
  EXPECT_FALSE(calibration.scale_known);
  double sum = 0.0;
  for (const Camera& camera : calibration.cameras)
    sum += glm::length(glm::dvec2(camera.centre_in_world()));
  EXPECT_NEAR(sum / double(calibration.cameras.size()), 1.0, 0.05);
  EXPECT_THAT(sentences_of(calibration), HasSubstr("measure a tape"));
}

TEST(SolveCameras, IsTheSameTwice) {
  const Orbit orbit = make_orbit({.seed = 13, .photos = 8});
  const Calibration a = solve(orbit, one_tape(orbit), false);
  const Calibration b = solve(orbit, one_tape(orbit), false);
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i)
    EXPECT_EQ(a.cameras[i].camera_from_world.translation,
              b.cameras[i].camera_from_world.translation);
  EXPECT_EQ(a.sentences, b.sentences);
}

TEST(SolveCameras, StopsWithin100Milliseconds) {
  const Orbit orbit = make_orbit({.photos = 40, .markers = 60});
  Progress progress;
  std::chrono::steady_clock::time_point asked;
  std::thread asker([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    asked = std::chrono::steady_clock::now();
    progress.cancel();
  });
  EXPECT_THROW(solve_cameras(orbit.photos, {}, {orbit.lens, true}, {}, progress), Cancelled);
  asker.join();
  const auto late = std::chrono::steady_clock::now() - asked;
  EXPECT_LT(late, std::chrono::milliseconds(300));  // 100 and what a busy machine adds
}

TEST(SolveCameras, RefusesInputThatContradictsItself) {
  Orbit orbit = make_orbit({.photos = 6});
  Progress progress;
  const auto solve_it = [&] {
    return solve_cameras(orbit.photos, {}, {orbit.lens, true}, {}, progress);
  };
  orbit.photos[1].photo = orbit.photos[0].photo;
  EXPECT_THROW(solve_it(), Error);
  orbit.photos[1].photo = "other";
  orbit.photos[2].sightings[0].point = orbit.photos[2].sightings[1].point;
  EXPECT_THROW(solve_it(), Error);
  orbit.photos[2].sightings[0].point = "unheard of";
  orbit.photos[2].sightings[0].sigma_px = 0.0;
  EXPECT_THROW(solve_it(), Error);
}

}  // namespace
}  // namespace bosk
