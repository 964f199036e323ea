#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/photo/camera.h"

namespace bosk {

// A photo as every stage after import sees it: at the working size, undistorted to a pinhole.
struct Photo {
  std::string name;        // file name without folder and ending
  Camera camera;           // pinhole, at the working size
  Camera original_camera;  // as photographed: own size and lens; used when a view is rendered to compare
  Image<glm::vec3> srgb;   // 0 to 1, sRGB-encoded; empty when only a matte was given
};
using Photos = std::vector<Photo>;

}  // namespace bosk
