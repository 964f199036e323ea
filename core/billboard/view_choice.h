#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/geometry/box.h"
#include "core/photo/camera.h"

namespace bosk {

// `count` viewpoints spread evenly over the upper hemisphere around the crown, at the photos'
// median distance: a golden-angle spiral from just below eye level (the photos') to straight above.
// Textures baked from the volume need not stand where the photographer stood.
std::vector<glm::dvec3> hemisphere_views(const std::vector<Camera>& cameras, const Box& crown,
                                         int count);

}  // namespace bosk
