#include "ui/gl_tree_pictures.h"

#include <GL/glcorearb.h>

#include <cstdint>
#include <memory>

#include "core/base/error.h"
#include "ui/forest_picture.h"

namespace bosk {
namespace {

// What is drawn to, put back at the end: the panel's picture is drawn in the middle of a frame.
class TargetKept {
 public:
  TargetKept() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  ~TargetKept() {
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }
  TargetKept(const TargetKept&) = delete;
  TargetKept& operator=(const TargetKept&) = delete;

 private:
  GLint framebuffer_ = 0, viewport_[4] = {0, 0, 0, 0};
};

// The scene drawn last, as the graphics memory holds it.
struct Stage {
  std::shared_ptr<const ForestScene> scene;
  std::unique_ptr<ForestPicture> picture;
};

void put_on(Stage& stage, const std::shared_ptr<const ForestScene>& scene,
            const std::string& driver) {
  if (stage.picture && stage.scene == scene) return;
  stage.picture.reset();
  stage.scene = scene;
  stage.picture =
      std::make_unique<ForestPicture>(*scene, driver, OffscreenTarget::Precision::bits_16);
}

}  // namespace

TreePictures gl_tree_pictures(const std::string& driver) {
  auto stage = std::make_shared<Stage>();
  return {[stage, driver](const std::shared_ptr<const ForestScene>& scene, const Camera& camera,
                          const ViewOptions& options, std::uint64_t budget, double wind_time_s) {
    DrawnPicture drawn;
    const TargetKept kept;
    try {
      put_on(*stage, scene, driver);
      drawn.figures = stage->picture->draw(camera, options, budget, wind_time_s);
      const auto name = std::intptr_t(stage->picture->colour_texture());
      drawn.texture = {reinterpret_cast<ImTextureID>(name),
                       {camera.lens.width_px, camera.lens.height_px}};
    } catch (const Error& error) {  // at the edge of a library: too large for the driver
      drawn.trouble = error.what();
    }
    return drawn;
  }};
}

}  // namespace bosk
