#include "ui/forest_scene.h"

#include <gtest/gtest.h>

#include "core/render/reference.h"
#include "core/render/scatter.h"
#include "tests/render/toy_trees.h"
#include "ui/frame_figures.h"
#include "ui/view_marks.h"

namespace bosk {
namespace {

std::shared_ptr<const SceneTree> ball() {
  TreeModel model = toy::random_ball(1);
  model.metadata.height_m = 2.0;
  return std::make_shared<const SceneTree>("ball", std::move(model));
}

ForestScene scene_of(int trees) {
  ScatterOptions options;
  options.trees = trees;
  auto tree = ball();
  auto instances = trees == 1 ? line_up(std::vector<double>{1.0})
                              : scatter_trees(std::vector<double>{1.0}, {}, options);
  return ForestScene({tree}, std::move(instances), {});
}

TEST(Framing, HoldsTheWholeTreeInEveryShapeOfPicture) {
  const ForestScene scene = scene_of(1);
  for (const glm::ivec2 size : {glm::ivec2(800, 600), {300, 900}, {1600, 200}}) {
    const Camera camera = camera_of(framing(scene, size, 0.8), size, 0.8);
    for (const double x : {-0.9, 0.9}) {
      for (const double z : {0.1, 1.9}) {
        const auto pixel = project(camera, {x, 0.0, z});
        ASSERT_TRUE(pixel);
        EXPECT_GT(pixel->x, 0.0);
        EXPECT_LT(pixel->x, size.x);
        EXPECT_GT(pixel->y, 0.0);
        EXPECT_LT(pixel->y, size.y);
      }
    }
  }
}

TEST(SceneTree, StandsAtItsOriginWhereverItWasCaptured) {
  const glm::dvec3 away(120.0, -40.0, -7.0);
  TreeModel model = toy::random_ball(1);
  model.origin += away;
  for (glm::dvec3& view : model.view_positions) view += away;
  model.metadata.height_m = 2.0 + away.z;
  const SceneTree moved("ball", model);
  EXPECT_NEAR(moved.model.metadata.height_m, 2.0, 0.2);  // the ball hangs 0.1 above its cube's foot
  EXPECT_NEAR(moved.crown_radius_m, ball()->crown_radius_m,
              0.3);  // its lowest cells are off its axis
  EXPECT_LT(glm::length(moved.prepared.lower() - glm::dvec3(-1, -1, 0)), 0.4);
  // Views move along
  EXPECT_NEAR(glm::distance(moved.model.view_positions[0], moved.model.origin),
              glm::distance(model.view_positions[0], model.origin), 1e-9);
  // One that stands at its origin is left as it is
  EXPECT_EQ(ball()->model.origin, toy::random_ball(1).origin);
}

TEST(Framing, LooksAtAForestFromOutsideAndAbove) {
  const ForestScene scene = scene_of(50);
  const ViewCamera view = framing(scene, {800, 600}, 0.8);
  EXPECT_GT(glm::distance(view.eye, scene.middle), scene.radius_m);
  EXPECT_GT(view.eye.z, scene.height_m);
  EXPECT_LT(view.pitch, 0.0);
}

TEST(Ground, HoldsTheTrunksOfSmallAndWideForests) {
  for (const double radius : {20.0, 400.0, 4000.0}) {
    const Terrain terrain = drawn_terrain({12.0, 80.0, 3}, radius);
    std::vector<TreeInstance> instances(2);
    instances[0].place = {-radius, -radius, 0.0};
    instances[1].place = {radius, radius, 0.0};
    const ForestScene scene({ball()}, std::move(instances), terrain);
    const Image<glm::vec3> ground = ground_points(scene);
    double worst = 0.0;
    for (int i = 1; i < ground.height(); i += 7) {  // midway between two points of a row
      const glm::dvec3 west = ground(i - 1, i), east = ground(i, i);
      const glm::dvec3 middle = 0.5 * (west + east);
      worst = std::max(worst, std::abs(height_at(terrain, middle.x, middle.y) - middle.z));
    }
    EXPECT_LT(worst, 0.2) << radius;  // metres: less than a trunk's flare
    EXPECT_LT(ground(0, 0).x, -radius);
    EXPECT_GT(ground(0, 0).y, radius);  // north first
  }
}

TEST(Ground, OfAPlaneTakesFourPoints) { EXPECT_EQ(ground_points(scene_of(1)).size(), 4u); }

TEST(Overdraw, IsTheBillboardsAreaOverThePictures) {
  const ForestScene scene = scene_of(1);
  const Camera camera = toy::look_at({0.0, -40.0, 1.0}, {0.0, 0.0, 1.0}, 2000.0, 200, 200);
  DrawOptions options;
  options.only_level = 4;
  options.dissolve = 1.0;
  ForestDrawList list;
  scene.forest.draw_list(viewpoint_of(camera), options, 0, list);
  const double side_px = 2000.0 / 40.0 * 1.3 * 2.0 / 16.0;  // side_factor 1.3, cube of 2 m
  const double expected = double(list.billboards) * side_px * side_px / (200.0 * 200.0);
  EXPECT_NEAR(overdraw_estimate(scene.forest, list, camera), expected, 1e-6 * expected);
}

TEST(HalfAngle, ReachesThePicturesCorners) {
  const Camera camera = toy::look_at({0.0, -4.0, 1.0}, {0.0, 0.0, 1.0}, 100.0, 200, 200);
  EXPECT_NEAR(half_angle_of(camera), std::atan(std::sqrt(2.0)), 1e-12);
}

TEST(ViewMarks, StandWhereTheTreesViewsAreAndTellTheTwoThatAreMixed) {
  const ForestScene scene = scene_of(1);
  const Camera camera = toy::look_at({0.0, -30.0, 4.0}, {0.0, 0.0, 1.0}, 600.0, 600, 400);
  const auto marks = view_marks(scene, camera, {});
  ASSERT_EQ(marks.size(), 8u);  // a ring of 8 with a radius of 6 m, all in the picture
  EXPECT_EQ(std::count_if(marks.begin(), marks.end(), [](auto& mark) { return mark.is_mixed; }), 2);
  Image<glm::u8vec3> picture(600, 400, glm::u8vec3(0));
  paint_marks(picture, marks);
  for (const ViewMark& mark : marks) {
    EXPECT_EQ(picture(int(mark.pixel.x), int(mark.pixel.y)),
              mark.is_mixed ? kMixedMarkColour : kMarkColour);
  }
}

}  // namespace
}  // namespace bosk
