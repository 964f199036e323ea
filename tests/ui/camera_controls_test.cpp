#include "ui/camera_controls.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bosk {
namespace {

const Terrain kFlat;
const Terrain kHills{8.0, 40.0, 5};
constexpr double kRight = 0.5 * std::numbers::pi;

ViewCamera from_south(double distance = 10.0) {
  return looking_at({}, {0.0, -distance, 5.0}, {0.0, 0.0, 5.0});
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  EXPECT_NEAR(glm::distance(a, b), 0.0, tolerance)
      << a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z;
}

TEST(ViewCamera, LooksAtItsTargetAndProjectsItToTheMiddle) {
  const ViewCamera view = looking_at({}, {3.0, -7.0, 2.0}, {1.0, 4.0, 6.0});
  expect_near(target_of(view), {1.0, 4.0, 6.0});
  const Camera camera = camera_of(view, {640, 480}, 0.8);
  const auto pixel = project(camera, {1.0, 4.0, 6.0});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x, 319.5, 1e-6);
  EXPECT_NEAR(pixel->y, 239.5, 1e-6);
  expect_near(camera.centre_in_world(), view.eye);
}

TEST(ViewCamera, PicturesAreUprightAndNotMirrored) {
  const Camera camera = camera_of(from_south(), {640, 480}, 0.8);
  EXPECT_GT(project(camera, {1.0, 0.0, 5.0})->x, 320.0);  // east is right, seen from the south
  EXPECT_LT(project(camera, {0.0, 0.0, 6.0})->y, 240.0);  // up is up
  EXPECT_NEAR(glm::determinant(camera.camera_from_world.rotation), 1.0, 1e-12);
  // The picture's height spans the angle
  EXPECT_NEAR(project(camera, {0.0, 0.0, 5.0 + 10.0 * std::tan(0.4)})->y, -0.5, 1e-6);
}

TEST(ViewCamera, TakesAnEyeOverItsTargetAndOneInIt) {
  const ViewCamera above = looking_at({}, {0.0, 0.0, 50.0}, {0.0, 0.0, 0.0});
  EXPECT_GE(above.pitch, -kSteepest);
  const ViewCamera inside = looking_at({}, {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0});
  EXPECT_EQ(inside.heading, kRight);
  EXPECT_GT(inside.distance, 0.0);
}

TEST(Orbit, DragKeepsTargetAndDistanceAndMovesTheSceneWithTheMouse) {
  const ViewCamera view = from_south();
  const ViewCamera right = dragged(view, {100.0, 0.0}, 400.0, kFlat);
  expect_near(target_of(right), target_of(view));
  EXPECT_NEAR(right.distance, 10.0, 1e-12);
  EXPECT_NEAR(right.heading, kRight - 0.25 * std::numbers::pi, 1e-12);  // half a turn a height
  EXPECT_LT(right.eye.x, 0.0);  // the eye goes west, so the tree's front goes east
  const ViewCamera down = dragged(view, {0.0, 50.0}, 400.0, kFlat);
  EXPECT_GT(down.eye.z, view.eye.z);
  EXPECT_LT(dragged(view, {0.0, 1e6}, 400.0, kFlat).pitch, -1.5);  // never beyond the top
}

TEST(Orbit, AFullTurnComesBack) {
  ViewCamera view = from_south();
  for (int i = 0; i < 8; ++i) view = dragged(view, {100.0, 0.0}, 400.0, kFlat);
  expect_near(view.eye, from_south().eye);
  for (int i = 0; i < 12; ++i) view = walked_round(view, std::numbers::pi / 6.0, kFlat);
  expect_near(view.eye, from_south().eye);
}

TEST(Orbit, WalksRoundCounterclockwise) {
  const ViewCamera quarter = walked_round(from_south(), kRight, kFlat);
  expect_near(quarter.eye, {10.0, 0.0, 5.0});  // from south to east
  expect_near(target_of(quarter), {0.0, 0.0, 5.0});
}

TEST(Orbit, StaysAboveTheGroundAndOnItsTarget) {
  const ViewCamera low = dragged(from_south(), {0.0, -300.0}, 400.0, kFlat);
  EXPECT_NEAR(low.eye.z, kClearance, 1e-9);
  expect_near(target_of(low), {0.0, 0.0, 5.0}, 1e-6);
}

TEST(Orbit, WheelGoesNearerAndStopsBeforeTheTarget) {
  const ViewCamera view = from_south();
  const ViewCamera near = zoomed(view, 1.0, kFlat);
  EXPECT_NEAR(near.distance, 8.5, 1e-12);
  expect_near(target_of(near), target_of(view));
  expect_near(zoomed(near, -1.0, kFlat).eye, view.eye);
  EXPECT_GT(zoomed(view, 1000.0, kFlat).distance, 0.0);
  EXPECT_LT(zoomed(view, -1000.0, kFlat).distance, 1e6);
}

TEST(Orbit, PanMovesWhatLiesAtTheTargetWithTheMouse) {
  const ViewCamera view = from_south();
  const ViewCamera moved_view = panned(view, {30.0, -20.0}, 480.0, 0.8, kFlat);
  const auto pixel = project(camera_of(moved_view, {640, 480}, 0.8), target_of(view));
  EXPECT_NEAR(pixel->x, 319.5 + 30.0, 1e-6);
  EXPECT_NEAR(pixel->y, 239.5 - 20.0, 1e-6);
}

TEST(Fly, MovesWhereItLooksAndFastWithShift) {
  ViewCamera view = switched(from_south(), ViewCamera::Mode::fly, kFlat);
  view.pitch = 0.5;
  view.speed = 2.0;
  Strides strides;
  strides.forward = 1.0;
  expect_near(moved(view, strides, 0.5, kFlat).eye, view.eye + forward_of(view));
  strides.fast = true;
  expect_near(moved(view, strides, 0.5, kFlat).eye, view.eye + 4.0 * forward_of(view));
  expect_near(moved(view, {.right = 1.0}, 1.0, kFlat).eye, view.eye + glm::dvec3(2.0, 0.0, 0.0));
  expect_near(moved(view, {.up = 1.0}, 1.0, kFlat).eye, view.eye + glm::dvec3(0.0, 0.0, 2.0));
}

TEST(Fly, TurnsTheHeadWhereTheMouseGoesAndTheWheelChangesSpeed) {
  const ViewCamera view = switched(from_south(), ViewCamera::Mode::fly, kFlat);
  const ViewCamera turned = dragged(view, {100.0, 100.0}, 400.0, kFlat);
  expect_near(turned.eye, view.eye);
  EXPECT_LT(turned.heading, view.heading);  // to the east: right
  EXPECT_LT(turned.pitch, view.pitch);      // down
  EXPECT_GT(zoomed(view, 2.0, kFlat).speed, view.speed);
  expect_near(zoomed(view, 2.0, kFlat).eye, view.eye);
}

TEST(Fly, StaysAboveTheGround) {
  ViewCamera view = switched(from_south(), ViewCamera::Mode::fly, kHills);
  view.pitch = -1.0;
  for (int i = 0; i < 100; ++i) {
    view = moved(view, {.forward = 1.0}, 0.1, kHills);
    EXPECT_GE(view.eye.z, height_at(kHills, view.eye.x, view.eye.y) + kClearance - 1e-9);
  }
}

TEST(Walk, FollowsTheGroundAtEyeHeight) {
  ViewCamera view = switched(from_south(), ViewCamera::Mode::walk, kHills);
  EXPECT_EQ(view.pitch, 0.0);
  view.pitch = 0.7;  // looking up doesn't lift the feet
  const glm::dvec3 start = view.eye;
  for (int i = 0; i < 50; ++i) {
    view = moved(view, {.forward = 1.0, .up = 1.0}, 0.1, kHills);
    EXPECT_NEAR(view.eye.z - height_at(kHills, view.eye.x, view.eye.y), 1.7, 1e-9);
  }
  EXPECT_NEAR(glm::distance(glm::dvec2(view.eye), glm::dvec2(start)), 5.0 * view.speed, 1e-6);
}

// The same keys and drags give the same eye, as a script would replay them.
TEST(ViewCamera, AScriptOfInputsEndsWhereExpected) {
  ViewCamera view = from_south();
  view = zoomed(view, 2.0, kFlat);
  view = dragged(view, {400.0, 0.0}, 400.0, kFlat);  // half a turn: from the north now
  EXPECT_NEAR(view.eye.y, 7.225, 1e-9);
  view = switched(view, ViewCamera::Mode::walk, kFlat);
  EXPECT_NEAR(view.eye.z, 1.7, 1e-12);
  view = moved(view, {.forward = 1.0}, 1.0, kFlat);
  expect_near(view.eye, {0.0, 3.225, 1.7}, 1e-6);
  view = switched(view, ViewCamera::Mode::orbit, kFlat);
  expect_near(view.eye, {0.0, 3.225, 1.7}, 1e-6);
}

}  // namespace
}  // namespace bosk
