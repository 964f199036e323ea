#pragma once

#include <glm/gtc/type_precision.hpp>
#include <memory>
#include <optional>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "core/render/gl/forest_renderer.h"
#include "core/render/gl/offscreen_target.h"
#include "core/render/gl/scenery_renderer.h"
#include "ui/forest_scene.h"
#include "ui/frame_figures.h"
#include "ui/view_options.h"

namespace bosk {

// Pictures of a scene: sky, ground with the trees' shadows, trees. Needs a current OpenGL context
// during every call, the destructor included.
class ForestPicture {
 public:
  // `driver` is told in the figures. Throws Error where the scene cannot be drawn.
  ForestPicture(const ForestScene& scene, std::string driver, OffscreenTarget::Precision precision);

  // Draws what the camera sees, at its size, with at most `budget` billboards (0: no bound), and
  // waits until the picture is finished.
  FrameFigures draw(const Camera& camera, const ViewOptions& options, std::uint64_t budget,
                    double wind_time_s);

  // The picture drawn last, opaque. Draw one first.
  Image<glm::u8vec3> read() const;
  // OpenGL's name of the texture that it lies in, bottom row first; 0 before the first. Another
  // size makes another texture.
  unsigned colour_texture() const { return target_ ? target_->colour_texture() : 0; }
  // Copies it into another framebuffer of the same size: 0 is the window's.
  void show(unsigned framebuffer) const;

 private:
  void resize(const Lens& lens);

  const ForestScene& scene_;
  std::string driver_;
  OffscreenTarget::Precision precision_;
  SceneryRenderer scenery_;
  ForestRenderer renderer_;
  std::optional<OffscreenTarget> target_;
  ForestDrawList list_;
};

}  // namespace bosk
