#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/image/image.h"

namespace bosk {

// A place where something compact stands off by its colour.
struct BallCandidate {
  glm::dvec2 centre_px{0.0};
  double radius_px = 0.0;
  double strength = 0.0;  // difference of saturation from the surroundings
};

// Blobs of about 2.5 to 8 px radius in a saturation image, the strongest first, at most `most`:
// maxima over place and size of a difference of Gaussians (Lindeberg 1998, "Feature detection with
// automatic scale selection"), along the direction of the blob's own colour.
std::vector<BallCandidate> find_blobs(const Image<glm::vec3>& saturation, std::size_t most);

}  // namespace bosk
