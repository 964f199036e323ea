#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"
#include "core/matte/clusters.h"
#include "core/matte/matte.h"

namespace bosk {

// One colour of the strokes and where it was drawn.
struct StrokeCluster {
  ColourCluster colour;
  // On a coarse grid over the whole image: squared distance to the cluster's nearest stroke pixel,
  // in units of the image diagonal. The grid goes from edge to edge, so it fits photos of other
  // sizes.
  Image<float> squared_distance;
};

// What the strokes over one photo teach.
struct StrokeModel {
  std::vector<StrokeCluster> foreground, background;
};

// The photo's pixels in CIELab, one plane per channel. `gain` multiplies linear light first.
struct LabPlanes {
  Image<float> l, a, b;
};
LabPlanes lab_planes(const Image<glm::vec3>& srgb, const glm::vec3& gain, Progress& progress);

// Clusters of both kinds of stroke. Foreground pixels whose colour is far more common under the
// background strokes are dropped first: hurried strokes run over gaps in the crown.
StrokeModel learn_strokes(const LabPlanes& lab, const Image<std::uint8_t>& strokes,
                          const MatteOptions& options);

}  // namespace bosk
