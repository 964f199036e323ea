#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"
#include "core/phantom/scene.h"
#include "core/photo/camera.h"

namespace bosk {

constexpr std::uint8_t kTreeNear = 1, kSolidNear = 2;

// For each pixel what its rays could meet, on the safe side: 0, kTreeNear, kSolidNear or both.
// Saves the rays of the pixels far from the tree.
Image<std::uint8_t> pixel_reach(const Camera& camera, const std::vector<glm::vec3>& vertices,
                                const std::vector<glm::uvec3>& triangles, const World& world);

}  // namespace bosk
