#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"
#include "core/matte/clusters.h"

namespace bosk {

// The photo's pixels in CIELab, one plane per channel.
struct LabPlanes {
  Image<float> l, a, b;
};
// Every `step`-th pixel of every `step`-th row. `gain` multiplies the linear light first. Calls
// progress.advance() for each row of the result.
LabPlanes lab_planes(const Image<glm::vec3>& srgb, const glm::vec3& gain, int step,
                     Progress& progress);

// One colour of the strokes and where it was drawn.
struct StrokeCluster {
  ColourCluster colour;
  // On a coarse grid over the whole image: squared distance to the cluster's nearest stroke pixel,
  // in units of the image diagonal. The grid goes from edge to edge, so it fits photos of other
  // sizes.
  Image<float> squared_distance;
};

// What the strokes over one photo teach. All distance grids have one size.
struct StrokeModel {
  std::vector<StrokeCluster> foreground, background;
};

// Clusters of one kind of stroke; none without such strokes.
std::vector<StrokeCluster> learn_clusters(const LabPlanes& lab, const Image<std::uint8_t>& strokes,
                                          std::uint8_t kind, int clusters);

// Clusters of both kinds of stroke. Foreground pixels whose colour is far more common under the
// background strokes are dropped first: hurried strokes run over gaps in the crown. `strokes` has
// the size of `lab` and both kinds.
StrokeModel learn_strokes(const LabPlanes& lab, const Image<std::uint8_t>& strokes, int clusters);

}  // namespace bosk
