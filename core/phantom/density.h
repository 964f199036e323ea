#pragma once

#include <vector>

#include "core/geometry/box.h"
#include "core/image/image.h"
#include "core/phantom/tree.h"

namespace bosk {

// The true volume: a cube of side^3 voxels round the tree, x fastest. Areas per volume, 1/m: one
// side of each leaf; the outside of wood. Leaves that face every way stop light like a medium of
// extinction 0.5 x leaf area, wood 0.25 x wood area.
struct TreeDensity {
  Box box;
  int side = 0;
  std::vector<float> leaf_area, wood_area;

  double voxel_m() const { return box.size().x / side; }
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(side) + std::size_t(y)) * std::size_t(side) +
           std::size_t(x);
  }
  float extinction(std::size_t voxel) const {
    return 0.5f * leaf_area[voxel] + 0.25f * wood_area[voxel];
  }
};

// Tree at rest. Each triangle is cut into pieces of at most a quarter voxel and each piece counted
// where its middle lies.
TreeDensity measure_density(const Tree& tree, int side);

}  // namespace bosk
