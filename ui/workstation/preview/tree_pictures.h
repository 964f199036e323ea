#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/photo/camera.h"
#include "ui/forest_scene.h"
#include "ui/frame_figures.h"
#include "ui/view_options.h"
#include "ui/widgets/pictures.h"

namespace bosk {

// A picture of a scene as a texture that its maker owns: its first row is the bottom one. Good
// until the next is drawn.
struct DrawnPicture {
  Texture texture;
  FrameFigures figures;
  std::string trouble;  // why there is no picture; empty: there is one
};

// Draws scenes fast. The window gives one that uses OpenGL; empty where there is none, and panels
// then draw with the CPU. On the interface thread alone.
struct TreePictures {
  std::function<DrawnPicture(const std::shared_ptr<const ForestScene>& scene, const Camera& camera,
                             const ViewOptions& options, std::uint64_t budget, double wind_time_s)>
      draw;
};

}  // namespace bosk
