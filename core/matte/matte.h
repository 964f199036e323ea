#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace bosk {

// The tree alone in one photo: straight sRGB-encoded colour (0 to 1) in rgb, opacity (0 to 1) in a.
// Same size and pixels as the photo's undistorted image. Colour where a = 0 is meaningless but finite.
struct Matte {
  std::string name;  // of the photo
  Image<glm::vec4> rgba;
};
using Mattes = std::vector<Matte>;  // in the order of the photos

}  // namespace bosk
