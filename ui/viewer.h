#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>

#include "core/base/progress.h"
#include "ui/forest_scene.h"
#include "ui/view_options.h"

namespace bosk {

struct ViewerStart {
  std::string title;
  ViewOptions options;
  ViewCamera camera;
  glm::ivec2 size{1280, 800};
  std::filesystem::path pictures = ".";  // folder that screenshots go to
};

// Opens a window on the scene and returns once it is closed. Draws a picture only when something
// changed. `say` is told of screenshots. Throws Error where no window opens, Cancelled when
// `progress` was asked to stop.
void run_viewer(const ForestScene& scene, const ViewerStart& start, const Progress& progress,
                const std::function<void(const std::string&)>& say);

}  // namespace bosk
