#include "core/calibrate/world.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/calibrate/bundle_normal.h"
#include "core/geometry/rotation.h"
#include "orbit.h"
#include "orbit_bundle.h"

namespace bosk {
namespace {

// The truth in another frame and scale.
OrbitBundle misplaced(const OrbitOptions& options = {.photos = 12, .gross = 0.0}) {
  OrbitBundle bundle = orbit_bundle(make_orbit(options));
  bundle.state =
      moved(bundle.state, {0.37, rotation_from_rodrigues({0.7, -1.2, 2.0}), {5.0, -3.0, 1.0}});
  return bundle;
}

glm::dvec3 true_point(int index, const OrbitOptions& options = {.photos = 12, .gross = 0.0}) {
  return orbit_bundle(make_orbit(options)).state.points[std::size_t(index)];
}

TEST(PlaceInWorld, NothingMeasuredLeavesAllSevenMovesFree) {
  OrbitBundle bundle = misplaced();
  const Determined determined = place_in_world(bundle.problem, bundle.state);
  EXPECT_EQ(determined.free.size(), 7u);
  EXPECT_FALSE(determined.scale || determined.up || determined.ground || determined.place);
  const glm::dvec3 crown = crown_point(bundle.state);
  EXPECT_NEAR(crown.x, 0.0, 1e-9);
  EXPECT_NEAR(crown.y, 0.0, 1e-9);
  // Up is across the cameras' plane: eye heights vary by 10 cm on a walk of 7 m.
  for (const RigidTransform& camera : bundle.state.camera_from_world) {
    EXPECT_NEAR(inverse(camera).translation.z, mean_centre(bundle.state).z, 0.03);
    EXPECT_LT((camera.rotation * glm::dvec3(0.0, 0.0, 1.0)).y, -0.9);
  }
}

TEST(PlaceInWorld, ATapeGivesScaleAlone) {
  OrbitBundle bundle = misplaced();
  const double length = glm::distance(true_point(0), true_point(1));
  bundle.problem.lengths = {{0, 1, length, 0.002, true}};
  const Determined determined = place_in_world(bundle.problem, bundle.state);
  EXPECT_TRUE(determined.scale);
  EXPECT_FALSE(determined.up);
  EXPECT_EQ(determined.free.size(), 6u);
  EXPECT_NEAR(glm::distance(bundle.state.points[0], bundle.state.points[1]), length, 1e-6);
}

TEST(PlaceInWorld, ThreeHeightsAndATapeGiveUpAndGround) {
  OrbitBundle bundle = misplaced();
  bundle.problem.lengths = {{0, 1, glm::distance(true_point(0), true_point(1)), 0.002, true}};
  for (const int i : {0, 2, 5})
    bundle.problem.coordinates.push_back({i, 2, true_point(i).z, 0.005, true});
  const Determined determined = place_in_world(bundle.problem, bundle.state);
  EXPECT_TRUE(determined.scale && determined.up && determined.ground);
  EXPECT_FALSE(determined.heading || determined.place);
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(bundle.state.points[std::size_t(i)].z, true_point(i).z, 1e-4) << i;
}

// Else nothing would hold the world along what was left out, and error bars would be endless.
TEST(DeterminedBy, WhatWasLeftOutDeterminesNothing) {
  OrbitBundle bundle = misplaced();
  bundle.problem.lengths = {{0, 1, glm::distance(true_point(0), true_point(1)), 0.002, true}};
  for (const int i : {0, 2, 5}) {
    for (int axis = 0; axis < 3; ++axis)
      bundle.problem.coordinates.push_back({i, axis, true_point(i)[axis], 0.005, true});
  }
  EXPECT_TRUE(place_in_world(bundle.problem, bundle.state).free.empty());
  for (CoordinateRow& row : bundle.problem.coordinates) row.used = row.axis == 2;
  const Determined determined = determined_by(bundle.problem, bundle.state);
  EXPECT_TRUE(determined.scale && determined.up && determined.ground);
  EXPECT_FALSE(determined.place || determined.heading);
  EXPECT_EQ(determined.free.size(), 3u);
}

TEST(PlaceInWorld, ThreeHeightsAloneGiveNoScale) {
  OrbitBundle bundle = misplaced();
  for (const int i : {0, 2, 5})
    bundle.problem.coordinates.push_back({i, 2, true_point(i).z, 0.005, true});
  const Determined determined = place_in_world(bundle.problem, bundle.state);
  EXPECT_FALSE(determined.scale && determined.up);
}

// What sticks don't tell, place and scale, must not run away while they are set upright.
TEST(PlaceInWorld, LeaningSticksAloneGiveUpAndKeepTheScene) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const OrbitOptions options{.seed = seed, .photos = 12, .gross = 0.0, .feet = true};
    OrbitBundle bundle = misplaced(options);
    Random random(seed);
    for (int top = 0; top < int(bundle.state.points.size()); top += 2) {
      bundle.problem.plumbs.push_back({top, top + 1});
      bundle.state.points[std::size_t(top)] +=
          0.004 * glm::dvec3(random.normal(), random.normal(), random.normal());
    }
    const BundleState before = bundle.state;
    const Determined determined = place_in_world(bundle.problem, bundle.state);
    EXPECT_TRUE(determined.up);
    EXPECT_FALSE(determined.scale || determined.place);
    const auto apart = [](const BundleState& state, std::size_t i) {
      return glm::distance(state.points[0], state.points[i]);
    };
    const double growth = apart(bundle.state, 1) / apart(before, 1);
    for (std::size_t i = 2; i < before.points.size(); ++i)  // rounding of coordinates about 10
      EXPECT_NEAR(apart(bundle.state, i) / apart(before, i), growth, 1e-9 * growth) << seed;
  }
}

TEST(PlaceInWorld, SurveyedPointsGiveAll) {
  OrbitBundle bundle = misplaced();
  for (const int i : {0, 3, 6})
    for (int axis = 0; axis < 3; ++axis)
      bundle.problem.coordinates.push_back({i, axis, true_point(i)[axis], 0.005, true});
  const Determined determined = place_in_world(bundle.problem, bundle.state);
  EXPECT_TRUE(determined.free.empty());
  for (int i = 0; i < 8; ++i)
    EXPECT_LT(glm::distance(bundle.state.points[std::size_t(i)], true_point(i)), 1e-4) << i;
}

}  // namespace
}  // namespace bosk
