#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/render/gl/forest_renderer.h"
#include "core/render/gl/headless_context.h"
#include "core/render/gl/offscreen_target.h"
#include "core/render/reference.h"
#include "tests/render/toy_trees.h"

namespace bosk {

// A test that draws. Skipped where there is no OpenGL; fails on anything that the driver complains
// of.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      context_.emplace(true);
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  void TearDown() override {
    if (!context_) return;
    for (const std::string& error : context_->errors()) ADD_FAILURE() << error;
  }

 private:
  std::optional<HeadlessContext> context_;
};

namespace toy {

// A model with what draws it: one instance at the origin unless others are given.
struct Grove {
  explicit Grove(TreeModel tree, std::vector<TreeInstance> instances = {{}})
      : model(std::make_unique<TreeModel>(std::move(tree))),
        prepared(std::make_shared<PreparedTree>(*model)),
        forest({prepared}, std::move(instances)) {}

  std::unique_ptr<TreeModel> model;
  std::shared_ptr<const PreparedTree> prepared;
  Forest forest;
};

struct Shot {
  Camera camera;
  DrawOptions draw{};
  ForestLook look{};
  ForestRendererOptions renderer{};
  glm::vec4 background{0.0f};
};

inline Image<glm::vec4> gl_picture(const Forest& forest, const Shot& shot) {
  OffscreenTarget target(shot.camera.lens.width_px, shot.camera.lens.height_px);
  target.bind();
  target.clear(shot.background);
  ForestRenderer renderer(forest, shot.renderer);
  ForestDrawList list;
  forest.draw_list(viewpoint_of(shot.camera), shot.draw, 0, list);
  renderer.draw(list, shot.camera, shot.look);
  return target.read();
}

inline glm::vec3 over_white(const glm::vec4& premultiplied) {
  return glm::vec3(premultiplied) + (1.0f - premultiplied.a);
}

inline double psnr_over_white(const Image<glm::vec4>& a, const Image<glm::vec4>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec3 difference(over_white(a.pixels()[i]) - over_white(b.pixels()[i]));
    sum += glm::dot(difference, difference) / 3.0;
  }
  return sum > 0.0 ? -10.0 * std::log10(sum / double(a.size()))
                   : std::numeric_limits<double>::infinity();
}

inline double opacity(const Image<glm::vec4>& image) {
  double sum = 0.0;
  for (const glm::vec4& pixel : image.pixels()) sum += double(pixel.a);
  return sum;
}

}  // namespace toy
}  // namespace bosk
