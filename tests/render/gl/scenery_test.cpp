#include "core/render/gl/crown_shadow.h"
#include "core/render/gl/scenery_renderer.h"
#include "tests/render/gl/gl_test.h"

namespace bosk {
namespace {

using SceneryTest = GlTest;

Image<glm::vec3> flat_ground(double half_m, int points, float height = 0.0f) {
  Image<glm::vec3> grid(points, points);
  for (int y = 0; y < points; ++y)
    for (int x = 0; x < points; ++x)
      grid(x, y) = {float(half_m * (2.0 * x / (points - 1) - 1.0)),
                    float(half_m * (2.0 * y / (points - 1) - 1.0)), height};
  return grid;
}

// One opaque cell of 1/4 m, 1.75 m above the ground at (0.125, 0.125).
TreeModel one_cell() {
  TreeModel model = toy::one_billboard();
  model.levels = {toy::make_level(3, 4, 1.0f, {toy::morton({4, 4, 6})}, 1,
                                  [](auto...) { return std::uint16_t(0); })};
  return model;
}

TEST(CrownShadow, HoldsTheOpacityOfACell) {
  const CrownShadow shadow = crown_shadow(one_cell(), glm::dvec3(0, 0, 1), 64);
  double dark_m2 = 0.0;
  const double px_m = 2.0 * shadow.radius_m / 64;
  for (const float transmittance : shadow.transmittance.pixels())
    dark_m2 += (1.0 - double(transmittance)) * px_m * px_m;
  EXPECT_NEAR(dark_m2, 0.25 * 0.25, 1e-4);
  EXPECT_LT(glm::distance(shadow.centre, glm::dvec3(0.125, 0.125, 1.625)), 1e-9);
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(shadow.transmittance(i, 0), 1.0f);
    EXPECT_EQ(shadow.transmittance(63, i), 1.0f);
  }
}

TEST(CrownShadow, IsClearForAnEmptyTreeAndASunOverhead) {
  const CrownShadow shadow = crown_shadow(TreeModel{}, glm::dvec3(0, 0, 1), 16);
  for (const float transmittance : shadow.transmittance.pixels()) EXPECT_EQ(transmittance, 1.0f);
}

TEST(CrownShadow, TakesTheFinestLevelThatIsSmallEnough) {
  const TreeModel ball = toy::random_ball(41);
  const glm::dvec3 sun = glm::normalize(glm::dvec3(1, 2, 3));
  const CrownShadow coarse = crown_shadow(ball, sun, 64, 1), fine = crown_shadow(ball, sun, 64);
  EXPECT_NE(coarse.transmittance, fine.transmittance);
  EXPECT_NEAR(glm::length(fine.across), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(fine.down, sun), 0.0, 1e-12);
}

Image<glm::vec4> scene(const Forest& forest, const Camera& camera, const SceneryLook& look,
                       const Image<glm::vec3>& ground, bool shadows = true) {
  OffscreenTarget target(camera.lens.width_px, camera.lens.height_px);
  target.bind();
  target.clear(glm::vec4(0.0f));
  SceneryRenderer scenery(ground);
  scenery.draw(camera, look);
  if (shadows) scenery.draw_shadows(forest, camera, look);
  return target.read();
}

TEST_F(SceneryTest, PutsSkyAboveTheHorizonAndGroundBelow) {
  const Camera camera = toy::look_at({0, -20, 2}, {0, 0, 2}, 60, 64, 64);
  const Image<glm::vec4> image =
      scene(toy::Grove(TreeModel{}).forest, camera, {}, flat_ground(5000.0, 3));
  EXPECT_GT(image(32, 4).b, image(32, 4).r);
  EXPECT_GT(image(32, 60).g, image(32, 60).b);
  for (const glm::vec4& pixel : image.pixels()) EXPECT_EQ(pixel.a, 1.0f);
}

TEST_F(SceneryTest, CastsTheShadowOfACellWhereTheSunSendsIt) {
  // From above, the sun in the east at 45 degrees: the shadow of a cell 1.625 m up falls 1.625 m
  // west
  const toy::Grove tree(one_cell());
  const Camera camera = toy::look_at({0, -1e-3, 10}, {0, 0, 0}, 100, 80, 80);  // 10 px a metre
  SceneryLook look;
  look.to_sun = {1, 0, 1};
  const Image<glm::vec3> ground = flat_ground(10.0, 33);
  const Image<glm::vec4> lit = scene(tree.forest, camera, look, ground, false);
  const Image<glm::vec4> shaded = scene(tree.forest, camera, look, ground);
  glm::dvec2 sum(0.0);
  double dark = 0.0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      const double darker = double(lit(x, y).g - shaded(x, y).g);
      EXPECT_GE(darker, -1e-3);
      sum += darker * glm::dvec2(x, y);
      dark += darker;
    }
  ASSERT_GT(dark, 0.1);
  const auto expected = project(camera, {0.125 - 1.625, 0.125, 0.0});
  EXPECT_LT(glm::distance(sum / dark, *expected), 0.5);
}

TEST_F(SceneryTest, HidesTreesBehindAHill) {
  const toy::Grove tree(toy::one_billboard());
  Image<glm::vec3> hill = flat_ground(20.0, 41);
  for (int x = 0; x < 41; ++x) hill(x, 15).z = 6.0f;  // 5 m in front of the tree
  const Camera camera = toy::look_at({0, -15, 1.5}, {0, 0, 1}, 100, 60, 60);
  for (const bool hidden : {true, false}) {
    OffscreenTarget target(60, 60);
    target.bind();
    target.clear(glm::vec4(0.0f));
    SceneryRenderer scenery(hidden ? hill : flat_ground(20.0, 41));
    scenery.draw(camera, {});
    const Image<glm::vec4> before = target.read();
    ForestRenderer renderer(tree.forest);
    ForestDrawList list;
    tree.forest.draw_list(viewpoint_of(camera), {}, 0, list);
    renderer.draw(list, camera, {});
    EXPECT_EQ(target.read() == before, hidden);
  }
}

TEST_F(SceneryTest, DrawsWithoutGroundOrPicture) {
  const toy::Grove tree(toy::one_billboard());
  const Camera camera = toy::look_at({0, -15, 1.5}, {0, 0, 1}, 100, 20, 20);
  EXPECT_GT(toy::opacity(scene(tree.forest, camera, {}, {})), 399.0);
  const Camera nothing = toy::look_at({0, -15, 1.5}, {0, 0, 1}, 100, 0, 0);
  EXPECT_TRUE(scene(tree.forest, nothing, {}, flat_ground(10.0, 5)).empty());
}

}  // namespace
}  // namespace bosk
