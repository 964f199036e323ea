#include "core/render/gl/forest_renderer.h"

#include <GL/glcorearb.h>

#include "core/render/gl/gl_camera.h"
#include "tests/render/gl/gl_test.h"

namespace bosk {
namespace {

using ForestRendererTest = GlTest;

Camera front(int width_px = 80, int height_px = 60) {
  return toy::look_at({0, -4, 1.5}, {0, 0, 1}, 100, width_px, height_px);
}

TEST_F(ForestRendererTest, DrawsNothingIntoEmptyPicturesAndOfEmptyTrees) {
  const toy::Grove ball(toy::random_ball(31));
  EXPECT_TRUE(toy::gl_picture(ball.forest, {front(0, 0)}).empty());
  EXPECT_TRUE(toy::gl_picture(ball.forest, {front(10, 0)}).empty());
  EXPECT_EQ(toy::opacity(toy::gl_picture(toy::Grove(TreeModel{}).forest, {front()})), 0.0);
  EXPECT_EQ(toy::opacity(toy::gl_picture(Forest({}, {}), {front()})), 0.0);
  EXPECT_EQ(toy::opacity(toy::gl_picture(Forest({ball.prepared}, {}), {front()})), 0.0);
}

TEST_F(ForestRendererTest, DrawsAPictureOfOnePixel) {
  toy::Shot shot{toy::look_at({0, -4, 1}, {0, 0, 1}, 1.0, 1, 1)};
  shot.draw.only_level = 3;
  const toy::Grove ball(toy::random_ball(32));
  RenderOptions options;
  options.level = 3;
  Progress quiet;
  const Image<glm::vec4> cpu =
      render_tree_premultiplied(*ball.prepared, shot.camera, options, quiet);
  // Billboards of a thousandth of the pixel's light, each rounded to 16 bits
  EXPECT_NEAR(toy::gl_picture(ball.forest, shot)(0, 0).a, cpu(0, 0).a, 0.05f);
}

TEST_F(ForestRendererTest, DrawsAHundredThousandTreesOfOneBillboard) {
  std::vector<TreeInstance> instances;
  instances.reserve(100'000);
  for (int row = 0; row < 250; ++row)
    for (int column = 0; column < 400; ++column)
      instances.push_back({0,
                           {2.0 * column - 400.0, 2.0 * row, 0.0},
                           0.1 * column,
                           0.4,
                           glm::vec3(0.5f, 1.0f, 0.25f)});
  const toy::Grove grove(toy::one_billboard(), std::move(instances));
  toy::Shot shot{toy::look_at({0, -300, 120}, {0, 250, 0}, 60, 64, 48)};
  const Image<glm::vec4> image = toy::gl_picture(grove.forest, shot);
  EXPECT_GT(toy::opacity(image), 200.0);
  for (const glm::vec4& pixel : image.pixels()) {
    ASSERT_NEAR(pixel.r, 0.5f * pixel.a, 2e-3f);
    ASSERT_NEAR(pixel.b, 0.25f * pixel.a, 2e-3f);
  }
}

TEST_F(ForestRendererTest, DrawsTheSameInBatches) {
  const toy::Grove ball(toy::random_ball(33));
  toy::Shot whole{front()}, batches{front()};
  batches.renderer.batch_billboards = 777;
  EXPECT_EQ(toy::gl_picture(ball.forest, whole), toy::gl_picture(ball.forest, batches));
}

TEST_F(ForestRendererTest, DrawsTheSameBitsWithoutWindAtAnyTime) {
  const toy::Grove ball(toy::random_ball(34));
  toy::Shot still{front()}, later{front()}, windy{front()};
  later.look.wind_time_s = 12.5;
  windy.look.wind_m = 0.2;
  windy.look.wind_time_s = 1.5;
  const Image<glm::vec4> image = toy::gl_picture(ball.forest, still);
  EXPECT_EQ(image, toy::gl_picture(ball.forest, later));
  EXPECT_NE(image, toy::gl_picture(ball.forest, windy));
}

TEST_F(ForestRendererTest, SwaysTheTopAndNotTheFoot) {
  TreeModel model = toy::one_billboard();
  model.levels = {toy::make_level(3, 4, 1.0f, {toy::morton({4, 4, 0}), toy::morton({4, 4, 7})}, 1,
                                  [](auto...) { return std::uint16_t(0); })};
  const toy::Grove grove(std::move(model));
  toy::Shot still{front()}, windy{front()};
  windy.look.wind_m = 0.3;
  const Image<glm::vec4> a = toy::gl_picture(grove.forest, still);
  const Image<glm::vec4> b = toy::gl_picture(grove.forest, windy);
  double top_change = 0.0, foot_change = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      (y < a.height() / 2 ? top_change : foot_change) += std::abs(double(a(x, y).a - b(x, y).a));
  EXPECT_GT(top_change, 5.0);
  EXPECT_LT(foot_change, 0.5);  // it grows with the square of the height: 1.2 mm here
}

// Fills the left half of the bound framebuffer's depth buffer with a plane at `depth_m`.
void fill_left_half(const OffscreenTarget& target, double depth_m) {
  const float depth = float(1.0 - kNear_m / depth_m);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, target.width_px() / 2, target.height_px());
  glClearNamedFramebufferfv(target.framebuffer(), GL_DEPTH, 0, &depth);
  glDisable(GL_SCISSOR_TEST);
}

TEST_F(ForestRendererTest, HidesBehindWhatTheDepthBufferHolds) {
  const toy::Grove grove(toy::one_billboard());
  const Camera camera = toy::look_at({0, -10, 1}, {0, 0, 1}, 200, 80, 80);  // at depth 10
  ForestRenderer renderer(grove.forest);
  ForestDrawList list;
  grove.forest.draw_list(viewpoint_of(camera), {}, 0, list);
  for (const double wall_m : {9.9, 10.1}) {
    OffscreenTarget target(80, 80);
    target.bind();
    target.clear(glm::vec4(0.0f));
    fill_left_half(target, wall_m);
    renderer.draw(list, camera, {});
    const Image<glm::vec4> image = target.read();
    EXPECT_NEAR(image(30, 40).a, wall_m < 10.0 ? 0.0f : 1.0f, 1e-3f);
    EXPECT_NEAR(image(50, 40).a, 1.0f, 1e-3f);
  }
}

TEST_F(ForestRendererTest, ColoursByLevelCellAndPruning) {
  TreeModel model = toy::random_ball(35);
  // The views nearest to the camera, of every second cell
  for (std::size_t i = 0; i < model.levels[2].alpha_indices.size(); ++i)
    if (i % 8 >= 5 && i % 16 < 8) model.levels[2].alpha_indices[i] = kPruned;
  const toy::Grove ball(std::move(model));
  const Image<glm::vec4> tree = toy::gl_picture(ball.forest, {front()});
  for (const auto colours : {ForestLook::Colours::levels, ForestLook::Colours::cells}) {
    toy::Shot shot{front()};
    shot.look.colours = colours;
    const Image<glm::vec4> image = toy::gl_picture(ball.forest, shot);
    EXPECT_NE(image, tree);
    for (std::size_t i = 0; i < tree.size(); ++i)
      ASSERT_EQ(image.pixels()[i].a, tree.pixels()[i].a);
  }
  toy::Shot shot{front()};
  shot.look.colours = ForestLook::Colours::pruned;
  EXPECT_GT(toy::opacity(toy::gl_picture(ball.forest, shot)), toy::opacity(tree));
}

TEST_F(ForestRendererTest, MovesTreesWithoutUploadingThemAgain) {
  const toy::Grove here(toy::random_ball(36));
  const toy::Grove there(toy::random_ball(36), {{0, {0.4, 0.0, 0.1}, 0.3, 0.8, glm::vec3(0.9f)}});
  ForestRenderer renderer(here.forest);
  renderer.set_instances(there.forest.instances());
  OffscreenTarget target(80, 60);
  target.bind();
  target.clear(glm::vec4(0.0f));
  ForestDrawList list;
  there.forest.draw_list(viewpoint_of(front()), {}, 0, list);
  renderer.draw(list, front(), {});
  EXPECT_EQ(target.read(), toy::gl_picture(there.forest, {front()}));
}

TEST_F(ForestRendererTest, DrawsTreesOfDifferentAtlases) {
  TreeModel green = toy::one_billboard(), red = toy::one_billboard(8);
  green.atlas = toy::plain_atlas({{0, 255, 0, 255}});
  red.atlas.width_px = red.atlas.height_px = 128;
  red.atlas.rgba.assign(std::size_t(128) * 128, glm::u8vec4(255, 0, 0, 255));
  red.levels[0].alpha_codes.first = red.levels[0].colour_codes.first = 700;
  const Forest forest(
      {std::make_shared<PreparedTree>(green), std::make_shared<PreparedTree>(red)},
      {{0, {-1.5, 0, 0}}, {1, {1.5, 0, 0}}, {0, {-1.5, 5, 2.5}}, {1, {1.5, 5, 2.5}}});
  toy::Shot shot{toy::look_at({0, -10, 1}, {0, 0, 1}, 150, 80, 60)};
  const Image<glm::vec4> image = toy::gl_picture(forest, shot);
  EXPECT_EQ(image(17, 30), glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(image(62, 30), glm::vec4(1, 0, 0, 1));
}

TEST_F(ForestRendererTest, SaysWhatItHoldsOnTheGpu) {
  const toy::Grove ball(toy::random_ball(37));
  const ForestRenderer renderer(ball.forest);
  EXPECT_FALSE(renderer.uses_bc3());  // the toy has no BC3 atlas
  EXPECT_EQ(renderer.memory().atlases, 64u * 64u * 4u);
  std::size_t blocks = 0;
  for (const TreeLevel& level : ball.model->levels) blocks += level.alpha_indices.size();
  EXPECT_EQ(renderer.memory().indices, 4 * blocks);
}

TEST(ForestRendererWithoutContext, SaysSo) {
  const toy::Grove ball(toy::random_ball(38));
  try {
    ForestRenderer renderer(ball.forest);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no OpenGL context is current"), std::string::npos);
  }
}

TEST(ForestRendererWithoutContext, SaysSoWhenItIsGoneLater) {
  const toy::Grove ball(toy::random_ball(39));
  std::optional<HeadlessContext> context;
  try {
    context.emplace();
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  ForestRenderer renderer(ball.forest);
  ForestDrawList list;
  ball.forest.draw_list(viewpoint_of(front()), {}, 0, list);
  context.reset();
  EXPECT_THROW(renderer.draw(list, front(), {}), Error);
}

}  // namespace
}  // namespace bosk
