#include "core/billboard/coarser.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bosk {
namespace {

using Children = std::array<std::int32_t, 8>;  // x fastest; SparseGrid::kAbsent where there is none

Children children_of(const SparseGrid& grid, const glm::ivec3& cell) {
  Children children;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 child = 2 * cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
    children[std::size_t(i)] = grid.find(child.x, child.y, child.z);
  }
  return children;
}

// Of light along the axes, each through four columns of two children.
double mean_transmittance(const RadianceVolume& volume, const Children& children) {
  std::array<double, 8> depth{};
  for (std::size_t i = 0; i < 8; ++i) {
    if (children[i] >= 0) depth[i] = volume.extinction[std::size_t(children[i])];
  }
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t bit = std::size_t(1) << axis;
    for (std::size_t i = 0; i < 8; ++i) {
      if ((i & bit) == 0) sum += std::exp(-depth[i] - depth[i | bit]);
    }
  }
  return sum / 12.0;
}

void add_colour(const RadianceVolume& volume, const Children& children, float* colour) {
  const std::size_t stride = std::size_t(volume.coefficients()) * 3;
  float weight = 0.0f;
  for (const std::int32_t child : children) {
    if (child < 0) continue;
    const float own = volume.extinction[std::size_t(child)];
    weight += own;
    for (std::size_t k = 0; k < stride; ++k) {
      colour[k] += own * volume.colour[std::size_t(child) * stride + k];
    }
  }
  for (std::size_t k = 0; k < stride && weight > 0.0f; ++k) colour[k] /= weight;
}

}  // namespace

RadianceVolume coarser_volume(const RadianceVolume& volume) {
  std::vector<glm::ivec3> cells;
  cells.reserve(volume.grid.size());
  for (const glm::u16vec3& cell : volume.grid.cells()) cells.push_back(glm::ivec3(cell) / 2);
  RadianceVolume result{volume.origin,
                        volume.size_m,
                        SparseGrid(volume.grid.level() - 1, cells),
                        volume.degree,
                        {},
                        {}};
  const std::size_t stride = std::size_t(volume.coefficients()) * 3;
  result.extinction.resize(result.grid.size());
  result.colour.resize(result.grid.size() * stride);
  tbb::parallel_for(std::size_t(0), result.grid.size(), [&](std::size_t i) {
    const Children children = children_of(volume.grid, glm::ivec3(result.grid.cells()[i]));
    result.extinction[i] = float(-std::log(std::max(mean_transmittance(volume, children), 1e-9)));
    add_colour(volume, children, &result.colour[i * stride]);
  });
  return result;
}

}  // namespace bosk
