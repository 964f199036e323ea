#pragma once

#include <vector>

#include "core/opacity/ray_cache.h"

namespace bosk {

using Row = float __attribute__((vector_size(16)));

// One cell while it is fitted, N = (degree + 1)^2: row 0 holds the mean colour and the extinction,
// row j the j-th coefficient's colour.
template <int N>
struct Node {
  Row rows[N];
};

// Of each cell, and one behind the last that is always empty.
template <int N>
using Nodes = std::vector<Node<N>>;

// What the ray met, front to back.
struct Sample {
  Row colour;  // lane 3 is 0
  float weights[8];
  std::int32_t support;
  float extinction;
  float kept;    // 1 - opacity of the sample
  float before;  // light left when the ray reaches it
};

// One lane's share of a step: the loss's derivatives by each node, and what it measured.
template <int N>
struct FitLane {
  Nodes<N> gradient;
  std::vector<Sample> samples;  // of one ray at a time
  double squared_error = 0.0;
  std::size_t rays = 0;
};

// Composites each ray of the tile and adds the loss's derivatives to the lane. For N = 1, 4 and 9,
// in clones for the processor's instruction sets.
template <int N>
void fit_tile(const RayCache& cache, std::span<const CachedRay> tile,
              const TrilinearSupport& support, const Nodes<N>& nodes, FitLane<N>& lane);

}  // namespace bosk
