#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/photo/camera.h"
#include "core/render/forest.h"

namespace bosk {

// What one picture of a forest took.
struct FrameFigures {
  std::uint64_t billboards = 0;
  std::vector<std::uint64_t> by_level;  // of the octree
  std::size_t ranges = 0;
  std::size_t instances = 0, instances_drawn = 0;
  std::uint64_t budget = 0;  // billboards; 0: no bound
  double detail = 1.0;       // that the budget left
  double overdraw = 0.0;
  double list_ms = 0.0;     // of the CPU, for the draw list
  double scenery_ms = 0.0;  // sky, ground and shade
  double trees_ms = 0.0;
  double picture_ms = 0.0;  // all of it, until the picture was finished
  std::size_t texture_bytes = 0, index_bytes = 0, cell_bytes = 0, frame_bytes = 0;  // on the GPU
  bool bc3 = false;
  std::string driver;
};

// Billboards over one another in a pixel, in the mean over the picture, about: those of a tree
// count as if all were at the depth of its middle, and those outside the picture count too.
double overdraw_estimate(const Forest& forest, const ForestDrawList& list, const Camera& camera);

// Of the cone around its axis that holds the whole picture of a pinhole.
double half_angle_of(const Camera& camera);

}  // namespace bosk
