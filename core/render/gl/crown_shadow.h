#pragma once

#include <glm/glm.hpp>

#include "core/image/image.h"
#include "core/package/tree_model.h"

namespace bosk {

// Light that a crown lets through, seen from the sun: a square map whose plane is perpendicular to
// the sun's rays. Its pixel (0, 0) and the last touch the corners of a square of 2 radius_m around
// `centre`, pixels from edge to edge.
struct CrownShadow {
  Image<float> transmittance;  // 1: all light; 1 all along the border
  glm::dvec3 centre{0.0};      // of the crown, tree frame
  glm::dvec3 across{0.0};      // unit vectors along rows and columns, tree frame
  glm::dvec3 down{0.0};
  double radius_m = 1.0;
};

// From the cells of the finest level with at most `most_cells` (else the coarsest), each a square
// of its billboard's size with the mean opacity of its codewords over all views. Unlike the model
// it takes a cell's opacity to be the same from the sun as from the photos. `to_sun` is in the
// tree's frame, of unit length.
CrownShadow crown_shadow(const TreeModel& model, const glm::dvec3& to_sun, int side_px,
                         std::size_t most_cells = 20'000);

}  // namespace bosk
