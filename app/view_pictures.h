#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/console.h"
#include "ui/forest_scene.h"
#include "ui/view_options.h"

namespace bosk {

// What is drawn without a window.
struct PictureArguments {
  std::string screenshot;  // file; empty: none
  std::string turntable;   // folder; empty: none
  int frames = 72;         // of the turntable, once round
  glm::ivec2 size_px{1280, 800};
};

// Draws the screenshot and the turntable that are asked for, and the turntable's video when ffmpeg
// is there; tells the result. Throws Error when there is no OpenGL or a file cannot be written.
void draw_pictures(const ForestScene& scene, const PictureArguments& arguments,
                   const ViewCamera& camera, const ViewOptions& options, Console& console);

}  // namespace bosk
