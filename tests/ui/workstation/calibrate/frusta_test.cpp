#include "ui/workstation/calibrate/frusta.h"

#include <gtest/gtest.h>

#include "tests/ui/workstation/round_cameras.h"

namespace bosk {
namespace {

const glm::dvec2 kSize(800, 600);

TEST(OrbitView, ShowsItsTargetInTheMiddleAndUpUpwards) {
  OrbitView view;
  view.target = {1, 2, 3};
  const Camera eye = camera_of(view, kSize);
  const auto middle = project(eye, view.target);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(glm::distance(*middle, 0.5 * kSize - 0.5), 0.0, 1e-9);
  const auto above = project(eye, view.target + glm::dvec3(0, 0, 1));
  EXPECT_LT(above->y, middle->y);
}

TEST(OrbitView, TheSceneFollowsTheMouse) {
  OrbitView view;
  view.elevation = 0.0;
  // A place between eye and target moves with the hand: right, and down
  const glm::dvec3 near = 0.5 * (view.target + eye_of(view));
  const glm::dvec2 before = *project(camera_of(view, kSize), near);
  const OrbitView right = turned(view, {20, 0}, kSize.y), down = turned(view, {0, 20}, kSize.y);
  EXPECT_GT(project(camera_of(right, kSize), near)->x, before.x);
  EXPECT_GT(project(camera_of(down, kSize), near)->y, before.y);
  const glm::dvec2 target = *project(camera_of(moved(view, {30, 12}, kSize.y), kSize), view.target);
  EXPECT_NEAR(target.x, 0.5 * kSize.x - 0.5 + 30, 0.1);  // exact at the target's distance
  EXPECT_NEAR(target.y, 0.5 * kSize.y - 0.5 + 12, 0.1);
}

TEST(OrbitView, NeverGoesOverThePoles) {
  OrbitView view;
  for (int i = 0; i < 100; ++i) view = turned(view, {0, 50}, kSize.y);
  EXPECT_DOUBLE_EQ(view.elevation, kSteepestOrbit);
  for (int i = 0; i < 100; ++i) view = turned(view, {0, -50}, kSize.y);
  EXPECT_DOUBLE_EQ(view.elevation, -kSteepestOrbit);
}

TEST(OrbitView, TheOverviewShowsAllCameras) {
  const auto cameras = cameras_at({0, 60, 120, 180, 240, 300});
  const Camera eye = camera_of(overview_of(cameras, {1, 2, 3}), kSize);
  for (const Camera& camera : cameras) {
    const auto seen = project(eye, camera.centre_in_world());
    ASSERT_TRUE(seen);
    EXPECT_GT(seen->x, 0.0);
    EXPECT_LT(seen->x, kSize.x);
    EXPECT_GT(seen->y, 0.0);
    EXPECT_LT(seen->y, kSize.y);
  }
}

TEST(CameraThrough, ShowsAllOfThePictureInTheMiddle) {
  const Camera camera = cameras_at({30})[0];
  const Camera through = camera_through(camera, {800, 500});
  const Frustum frustum = frustum_of(camera, 2.0);
  const glm::dvec2 first = *project(through, frustum.corners[0]);
  const glm::dvec2 last = *project(through, frustum.corners[2]);
  // 400 x 300 fits 1 2/3 times: 666 2/3 x 500, from the outer edges of the pixels
  EXPECT_NEAR(last.x - first.x, 2000.0 / 3.0, 1e-6);
  EXPECT_NEAR(last.y - first.y, 500.0, 1e-6);
  EXPECT_NEAR(first.x + 0.5, (800.0 - 2000.0 / 3.0) / 2.0, 1e-6);
}

TEST(Frustum, ItsCornersAreSeenAtThePicturesCorners) {
  Camera camera = cameras_at({70})[0];
  camera.lens.model = LensModel::opencv;
  camera.lens.distortion[0] = -0.08;
  const Frustum frustum = frustum_of(camera, 1.5);
  const glm::dvec2 corners[] = {{-0.5, -0.5}, {399.5, -0.5}, {399.5, 299.5}, {-0.5, 299.5}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto seen = project(camera, frustum.corners[i]);
    ASSERT_TRUE(seen);
    EXPECT_LT(glm::distance(*seen, corners[i]), 1e-6);
    EXPECT_NEAR((camera.camera_from_world * frustum.corners[i]).z, 1.5, 1e-9);
  }
  EXPECT_EQ(frustum.at(0, 0), frustum.corners[0]);
  EXPECT_EQ(frustum.at(1, 1), frustum.corners[2]);
}

TEST(BackToFront, BeginsWithTheFarthestPicture) {
  const auto cameras = cameras_at({0, 180, 90});
  std::vector<Frustum> frusta;
  for (const Camera& camera : cameras) frusta.push_back(frustum_of(camera, 1.0));
  EXPECT_EQ(back_to_front(frusta, {30, 2, 3}), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(SeenLine, EndsWhereItGoesBehindTheCamera) {
  const Camera eye = camera_looking("eye", {0, 0, 0}, {1, 0, 0});
  EXPECT_FALSE(seen_line(eye, {-1, 0, 0}, {-2, 1, 0}));
  const auto seen = seen_line(eye, {2, 0, 0}, {-2, 1, 0});
  ASSERT_TRUE(seen);
  EXPECT_LT(glm::distance(seen->first, glm::dvec2(199.5, 149.5)), 1e-9);
  EXPECT_TRUE(std::isfinite(seen->second.x));
  EXPECT_FALSE(seen_quad(eye, {glm::dvec3(1, 0, 0), {1, 1, 0}, {-1, 1, 1}, {-1, 0, 1}}));
}

TEST(IsInside, HoldsBothWaysRound) {
  const std::array<glm::dvec2, 4> quad{glm::dvec2(0, 0), {4, 0}, {4, 2}, {0, 2}};
  const std::array<glm::dvec2, 4> other_way{quad[3], quad[2], quad[1], quad[0]};
  for (const auto& each : {quad, other_way}) {
    EXPECT_TRUE(is_inside(each, {1, 1}));
    EXPECT_FALSE(is_inside(each, {5, 1}));
    EXPECT_FALSE(is_inside(each, {1, -0.1}));
  }
}

TEST(GridStep, IsRoundAndAboutATenth) {
  EXPECT_DOUBLE_EQ(grid_step(10.0), 1.0);
  EXPECT_DOUBLE_EQ(grid_step(13.0), 2.0);
  EXPECT_DOUBLE_EQ(grid_step(0.4), 0.05);
  EXPECT_DOUBLE_EQ(grid_step(700.0), 100.0);
}

}  // namespace
}  // namespace bosk
