#pragma once

#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/image/image.h"
#include "core/photo/camera.h"
#include "ui/forest_scene.h"

namespace bosk {

// The place of one camera that a tree's textures were baked towards, in the picture.
struct ViewMark {
  glm::dvec2 pixel{0.0};
  bool is_mixed =
      false;  // one of the two that are nearest in angle to the eye, from the tree's middle
};

// The camera wheel of the tree that stands nearest to `target`; marks behind the eye or outside the
// picture are left out.
std::vector<ViewMark> view_marks(const ForestScene& scene, const Camera& camera,
                                 const glm::dvec3& target);

// Paints them as dots, as the window does.
void paint_marks(Image<glm::u8vec3>& picture, const std::vector<ViewMark>& marks);
inline constexpr double kMarkRadius = 4.0;  // pixels
inline constexpr glm::u8vec3 kMarkColour{255, 200, 40}, kMixedMarkColour{255, 60, 40};

}  // namespace bosk
