#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"

namespace bosk {

// Pictures for tests of what is found in photos, sRGB.

// Noisy grass.
Image<glm::vec3> meadow(int width, int height);
// A ball lit from above left, its edge smooth over a pixel.
void draw_ball(Image<glm::vec3>& image, const glm::dvec2& centre, double radius,
               const glm::vec3& srgb);
// An upright stick, 2 px wide, from the top down to the row `foot`.
void draw_stick(Image<glm::vec3>& image, const glm::dvec2& top, double foot);
// Leaves that hide what lies left of `x`, from row `top` to `bottom`.
void draw_leaves(Image<glm::vec3>& image, double x, int left, int top, int bottom);

}  // namespace bosk
