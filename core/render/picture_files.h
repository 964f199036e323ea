#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/photo/camera.h"

namespace bosk {

// Draws what a camera sees, straight colour, in its lens and size.
using CameraPainter = std::function<Image<glm::vec4>(const Camera&)>;

struct PictureFile {
  std::filesystem::path path;
  double draw_ms = 0.0;
};

// FOLDER/NAME.png for each camera: RGBA, straight alpha. The folder is made when missing. Throws
// Error when a file cannot be written.
std::vector<PictureFile> write_pictures(std::span<const Camera> cameras, const CameraPainter& paint,
                                        const std::filesystem::path& folder, Progress& progress);

}  // namespace bosk
