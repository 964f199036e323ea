// The GPU's pictures against the CPU reference's.

#include <squish.h>

#include "tests/render/gl/gl_test.h"

namespace bosk {
namespace {

// What 16-bit colour, rounded once a billboard, and geometry in single precision may cost; 70 to 76
// were measured, and nothing else differs.
constexpr double kLeastPsnr_db = 65.0;

using ForestAgreement = GlTest;

Image<glm::vec4> cpu_picture(const PreparedTree& tree, const toy::Shot& shot, bool gpu_texels) {
  RenderOptions options;
  options.level = shot.draw.only_level;
  options.detail = shot.draw.detail;
  options.blend = shot.look.blend == BlendRule::linear ? "linear" : "fading";
  options.gpu_texels = gpu_texels;
  Progress quiet;
  return render_tree_premultiplied(tree, shot.camera, options, quiet);
}

void expect_agreement(const toy::Grove& grove, const toy::Shot& shot, const std::string& what,
                      bool gpu_texels = false) {
  const Image<glm::vec4> cpu = cpu_picture(*grove.prepared, shot, gpu_texels);
  const Image<glm::vec4> gl = toy::gl_picture(grove.forest, shot);
  const double psnr_db = toy::psnr_over_white(cpu, gl);
  testing::Test::RecordProperty(what, std::to_string(psnr_db));
  EXPECT_GT(psnr_db, kLeastPsnr_db) << what;
  EXPECT_GT(toy::opacity(gl), 0.0) << what;
}

Camera bent(Camera camera, LensModel model) {
  camera.lens.model = model;
  if (model == LensModel::opencv)
    camera.lens.distortion = {-0.25, 0.06, 0.002, -0.003, 0.01, 0.02, -0.01, 0.005};
  if (model == LensModel::opencv_fisheye) camera.lens.distortion = {0.02, -0.01, 0.003, 0.0};
  return camera;
}

// Blocks of four texels that BC3 holds nearly: ramps between two colours.
CodeAtlas ramp_atlas() {
  CodeAtlas atlas = toy::noise_atlas(1);
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t x = 0; x < 64; ++x)
      atlas.rgba[64 * y + x] = glm::u8vec4(x * 4, y * 4, 60, 255 - 2 * x);
  atlas.bc3.resize(std::size_t(64) * 64);
  for (std::size_t tile = 0; tile < 256; ++tile) {
    glm::u8vec4 texels[16];
    for (std::size_t i = 0; i < 16; ++i)
      texels[i] = atlas.rgba[64 * (4 * (tile / 16) + i / 4) + 4 * (tile % 16) + i % 4];
    squish::Compress(&texels[0].r, &atlas.bc3[16 * tile], squish::kDxt5);
  }
  return atlas;
}

TEST_F(ForestAgreement, OfOneLevelWithBothSizesOfTextureUprightAndRolled) {
  for (const int texels : {4, 8}) {
    const toy::Grove grove(toy::random_ball(21, texels));
    for (const int level : {3, 4, 5}) {
      for (const double roll_degrees : {0.0, 2.0, 5.0}) {
        toy::Shot shot;
        shot.camera = toy::look_at({0, -4, 1.8}, {0, 0, 1}, 150, 110, 96,
                                   roll_degrees * std::numbers::pi / 180.0);
        shot.draw.only_level = level;
        expect_agreement(grove, shot,
                         "texels_" + std::to_string(texels) + "_level_" + std::to_string(level) +
                             "_roll_" + std::to_string(int(roll_degrees)));
      }
    }
  }
}

TEST_F(ForestAgreement, OfTurnedCamerasWhoseRowsAreSplitAndExchanged) {
  const toy::Grove grove(toy::random_ball(22, 8));
  for (const double roll : {0.4, 0.9, 1.6, 3.0, -1.2}) {
    toy::Shot shot;
    shot.camera = toy::look_at({1, -3, 2.5}, {0, 0, 1}, 200, 120, 100, roll);
    shot.draw.only_level = 3;
    expect_agreement(grove, shot, "roll_" + std::to_string(int(100 * roll)));
  }
}

TEST_F(ForestAgreement, OfMixedLevelsThatDissolveIntoEachOther) {
  TreeModel model = toy::random_ball(23);
  model.levels[0].max_cell_px = 10.0f;
  model.levels[1].max_cell_px = 5.2f;
  const toy::Grove grove(std::move(model));
  for (const double detail : {0.6, 1.0, 1.3}) {
    toy::Shot shot;
    shot.draw.detail = detail;
    shot.camera = toy::look_at({0, -3, 1.8}, {0, 0, 1}, 150, 110, 96);
    ForestDrawList list;
    grove.forest.draw_list(viewpoint_of(shot.camera), shot.draw, 0, list);
    const bool fades = std::any_of(list.ranges.begin(), list.ranges.end(),
                                   [](const DrawRange& range) { return range.fade < 1.0f; });
    EXPECT_TRUE(fades || detail != 1.0);
    expect_agreement(grove, shot, "detail_" + std::to_string(int(10 * detail)));
  }
}

TEST_F(ForestAgreement, OfDistortedLenses) {
  const toy::Grove grove(toy::random_ball(24));
  for (const LensModel lens : {LensModel::pinhole, LensModel::opencv, LensModel::opencv_fisheye}) {
    for (const double focal_px : {60.0, 150.0}) {
      toy::Shot shot;
      shot.camera =
          bent(toy::look_at({0.5, -2.2, 1.4}, {0.1, 0, 1}, focal_px, 120, 90, 0.05), lens);
      shot.camera.lens.principal_px += glm::dvec2(3.3, -2.1);
      shot.camera.lens.focal_px.y *= 1.03;
      expect_agreement(grove, shot,
                       "lens_" + std::to_string(int(lens)) + "_f_" + std::to_string(int(focal_px)));
    }
  }
}

TEST_F(ForestAgreement, OfEyesInsideTheCrown) {
  const toy::Grove grove(toy::random_ball(25, 8));
  for (const glm::dvec3 eye : {glm::dvec3(0.01, 0.02, 1.03), {0.0, 0.0, 1.0}, {0.5, 0.5, 1.2}}) {
    for (const glm::dvec3 target : {glm::dvec3(1, 0, 1), {0.1, 0.2, -3}, {-1, -1, 1}}) {
      for (const LensModel lens : {LensModel::pinhole, LensModel::opencv}) {
        toy::Shot shot;
        shot.camera = bent(toy::look_at(eye, target + glm::dvec3(0.001, 0, 0), 60, 64, 48), lens);
        shot.draw.only_level = 4;
        expect_agreement(grove, shot, "inside");
      }
    }
  }
}

TEST_F(ForestAgreement, OfBothBlendRulesAndFewViews) {
  for (const int views : {1, 2, 3, 8}) {
    const toy::Grove grove(toy::random_ball(26, 4, views));
    for (const BlendRule rule : {BlendRule::linear, BlendRule::fading}) {
      toy::Shot shot;
      shot.camera = toy::look_at({2.5, -3, 1.3}, {0, 0, 1}, 150, 100, 90);
      shot.look.blend = rule;
      expect_agreement(grove, shot, "views_" + std::to_string(views));
    }
  }
}

TEST_F(ForestAgreement, OfPrunedTexturesAndStrayCodewords) {
  TreeModel model = toy::random_ball(27, 8);
  std::mt19937 random(3);
  for (TreeLevel& level : model.levels) {
    for (std::size_t first = 0; first < level.alpha_indices.size(); first += 4) {
      if (random() % 3 == 0)
        std::fill_n(level.alpha_indices.begin() + std::ptrdiff_t(first), 4, kPruned);
      else if (random() % 3 == 0)
        level.alpha_indices[first + random() % 4] = kPruned;
      else if (random() % 5 == 0)
        level.colour_indices[first] = 999;
    }
  }
  toy::Shot shot;
  shot.camera = toy::look_at({0, -4, 1.8}, {0, 0, 1}, 150, 110, 96);
  expect_agreement(toy::Grove(std::move(model)), shot, "pruned");
}

TEST_F(ForestAgreement, OfCompressedAndPlainAtlases) {
  TreeModel model = toy::random_ball(28);
  model.atlas = ramp_atlas();
  const toy::Grove grove(std::move(model));
  toy::Shot shot;
  shot.camera = toy::look_at({0, -4, 1.8}, {0, 0, 1}, 150, 110, 96);
  shot.renderer.atlas = AtlasTexels::bc3;
  expect_agreement(grove, shot, "bc3", true);
  shot.renderer.atlas = AtlasTexels::plain;
  expect_agreement(grove, shot, "plain");
}

TEST_F(ForestAgreement, OfATreeThatStandsElsewhereTurnedAndScaled) {
  // The same picture as of the untouched tree from where its own frame sees the camera
  const TreeInstance instance{0, {120.0, -45.0, 3.0}, 0.7, 1.8, glm::vec3(1.0f)};
  const toy::Grove moved(toy::random_ball(29), {instance});
  toy::Shot shot;
  shot.camera = toy::look_at({120.5, -53.0, 6.2}, {120, -45, 4.8}, 150, 110, 96, 0.03);
  shot.draw.only_level = 5;
  toy::Shot from_tree = shot;
  const RigidTransform& camera = shot.camera.camera_from_world;
  const double c = std::cos(instance.turn), s = std::sin(instance.turn);
  from_tree.camera.camera_from_world.rotation =
      camera.rotation * glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
  from_tree.camera.camera_from_world.translation = (camera * instance.place) / instance.scale;
  const Image<glm::vec4> cpu = cpu_picture(*moved.prepared, from_tree, false);
  EXPECT_GT(toy::psnr_over_white(cpu, toy::gl_picture(moved.forest, shot)), kLeastPsnr_db);
}

}  // namespace
}  // namespace bosk
